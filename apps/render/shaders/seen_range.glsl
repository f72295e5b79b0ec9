// SPDX-License-Identifier: Apache-2.0
// How far the eye sees through a pixel's samples.

#include "fog_top.glsl"
#include "sample_count.glsl"

const int sample_count = SAMPLE_COUNT;  // of a pixel

#if SAMPLE_COUNT == 1
uniform sampler2D depths;
float sample_depth(ivec2 pixel, int i) { return texelFetch(depths, min(pixel, textureSize(depths, 0) - 1), 0).r; }
#else
uniform sampler2DMS depths;
float sample_depth(ivec2 pixel, int i) { return texelFetch(depths, min(pixel, textureSize(depths) - 1), i).r; }
#endif

uniform vec2 pixel_size;  // 2 over the picture's size: of a pixel in clip space
uniform mat4 direction_from_clip;
uniform vec3 forward;      // unit: the camera's axis
uniform float near_plane;  // metres

// Metres to the surface or to the end of the fog.
struct SeenRanges {
  float ranges[sample_count];
  float nearest;
  float farthest;
  float mean;
  float deviation;  // standard deviation
};

// Unit direction from the eye through the middle of a pixel, which may lie beyond the picture's edge.
vec3 pixel_direction(ivec2 pixel) {
  vec4 seen = direction_from_clip * vec4((vec2(pixel) + 0.5) * pixel_size - 1.0, 0.0, 1.0);
  return normalize(seen.xyz / seen.w);
}

SeenRanges seen_ranges(ivec2 pixel, vec3 direction) {
  SeenRanges seen;
  seen.nearest = 3.4e38;
  seen.farthest = 0.0;
  seen.mean = 0.0;
  for (int i = 0; i < sample_count; ++i) {
    float depth = sample_depth(pixel, i);  // 1 - near / distance along the axis
    float range = depth < 1.0 ? near_plane / ((1.0 - depth) * dot(direction, forward)) : fog_before_sky(direction);
    seen.ranges[i] = range;
    seen.nearest = min(seen.nearest, range);
    seen.farthest = max(seen.farthest, range);
    seen.mean += range / float(sample_count);
  }
  float variance = 0.0;
  for (int i = 0; i < sample_count; ++i) {
    float off = seen.ranges[i] - seen.mean;
    variance += off * off / float(sample_count);
  }
  seen.deviation = sqrt(variance);
  return seen;
}
