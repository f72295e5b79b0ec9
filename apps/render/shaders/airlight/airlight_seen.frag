// SPDX-License-Identifier: Apache-2.0
// How far the eye sees through a pixel's samples, summed up by four ranges.

#include "fog_top.glsl"
#include "generated/sample_count.glsl"

const int sample_count = SAMPLE_COUNT;  // a pixel

#if SAMPLE_COUNT == 1
uniform sampler2D depths;
float sample_depth(ivec2 pixel, int i) { return texelFetch(depths, pixel, 0).r; }
#else
uniform sampler2DMS depths;
float sample_depth(ivec2 pixel, int i) { return texelFetch(depths, pixel, i).r; }
#endif

in vec3 seen_direction;

uniform vec3 forward;      // unit: the camera's axis
uniform float near_plane;  // metres

out vec4 seen;  // metres: middles of the nearest quarter of the samples, of the next, and so on

void put_in_order(inout float nearer, inout float farther) {
  float least = min(nearer, farther);
  farther = max(nearer, farther);
  nearer = least;
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec3 direction = normalize(seen_direction);
  float sky_range = fog_before_sky(direction);
  float near_range = near_plane / dot(direction, forward);
  float sorted[sample_count];  // metres to the surface that a sample sees, or to the end of the fog
  for (int i = 0; i < sample_count; ++i) {
    float depth = sample_depth(pixel, i);  // near_plane / distance along the axis
    sorted[i] = depth > 0.0 ? near_range / depth : sky_range;
  }
  // Odd-even transposition sort: no index depends on a range, so that compilers unroll it.
  for (int turn = 0; turn < sample_count; turn += 2) {
    for (int i = 0; i < sample_count - 1; i += 2) put_in_order(sorted[i], sorted[i + 1]);
    for (int i = 1; i < sample_count - 1; i += 2) put_in_order(sorted[i], sorted[i + 1]);
  }
  for (int quarter = 0; quarter < 4; ++quarter) {
    int first = quarter * sample_count / 4;
    int last = max((quarter + 1) * sample_count / 4 - 1, first);
    seen[quarter] = 0.5 * (sorted[first] + sorted[last]);
  }
}
