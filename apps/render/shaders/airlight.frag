// SPDX-License-Identifier: Apache-2.0
// The airlight of one light along the ray through each pixel, to what the pixel's samples see.

#include "cookie.glsl"
#include "seen_range.glsl"
#include "light_list.glsl"
#include "litfog/shaders/glow.glsl"

flat in int light_index;

uniform vec3 eye;
uniform float asymmetry;
uniform int pixel_step;  // pixels between the target's texels

out vec4 color;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy) * pixel_step;
  vec3 direction = pixel_direction(pixel);
  SeenRanges seen = seen_ranges(pixel, direction);
  LitfogLight light = litfog_buffered_light(light_index);
  // Facing the eye all samples are as far. Over a slope two ranges stand for them, with their mean and deviation. At an
  // edge each sample has its own.
  bool is_slope = seen.farthest > 1.02 * seen.nearest;
  bool is_edge = seen.farthest > (light.axis_profile.w == 3.0 ? 1.03 : 1.06) * seen.nearest;  // a cookie is not smooth
  int evaluations = is_edge ? sample_count : is_slope ? 2 : 1;
  vec3 sum = vec3(0.0);
  for (int i = 0; i < evaluations; ++i) {
    float range = is_edge ? seen.ranges[i] : is_slope ? seen.mean + (float(i) * 2.0 - 1.0) * seen.deviation : seen.mean;
    sum += litfog_glow(light, eye, direction, range, asymmetry);
  }
  color = vec4(sum / float(evaluations), 0.0);
}
