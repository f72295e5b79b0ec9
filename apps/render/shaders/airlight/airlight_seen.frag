// SPDX-License-Identifier: Apache-2.0
// How far the eye sees through a pixel's samples: four ranges stand for them all.

#include "fog_top.glsl"
#include "litfog/shaders/fog.glsl"
#include "pixel_direction.glsl"
#include "sample_count.glsl"

const int sample_count = SAMPLE_COUNT;  // of a pixel

#if SAMPLE_COUNT == 1
uniform sampler2D depths;
float sample_depth(ivec2 pixel, int i) { return texelFetch(depths, pixel, 0).r; }
#else
uniform sampler2DMS depths;
float sample_depth(ivec2 pixel, int i) { return texelFetch(depths, pixel, i).r; }
#endif

uniform vec3 forward;      // unit: the camera's axis
uniform float near_plane;  // metres

layout(location = 0) out vec4 seen;  // metres: means of the nearest quarter of the samples, of the next, and so on
layout(location = 1) out float mean_opacity;  // of the scene's fog before them

// Metres to the surface that a sample sees, or to the end of the fog.
float sample_range(ivec2 pixel, vec3 direction, int i) {
  float depth = sample_depth(pixel, i);  // near_plane / distance along the axis
  return depth > 0.0 ? near_plane / (depth * dot(direction, forward)) : fog_before_sky(direction);
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec3 direction = pixel_direction(pixel);
  float sorted[sample_count];
  for (int i = 0; i < sample_count; ++i) {
    float range = sample_range(pixel, direction, i);
    int place = i;
    for (; place > 0 && sorted[place - 1] > range; --place) sorted[place] = sorted[place - 1];
    sorted[place] = range;
  }
  for (int quarter = 0; quarter < 4; ++quarter) {
    int first = quarter * sample_count / 4;
    int last = max((quarter + 1) * sample_count / 4 - 1, first);
    seen[quarter] = 0.5 * (sorted[first] + sorted[last]);
  }
  mean_opacity = 0.0;
  for (int quarter = 0; quarter < 4; ++quarter) mean_opacity += 0.25 * litfog_fog_opacity(seen[quarter], 1.0);
}
