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
  // Over a surface's slope the airlight is straight; at its edge each sample has its own.
  int evaluations = is_edge(seen) ? sample_count : 1;
  vec3 sum = vec3(0.0);
  for (int i = 0; i < evaluations; ++i) {
    sum += litfog_glow(light, eye, direction, evaluations > 1 ? seen.ranges[i] : seen.mean, asymmetry);
  }
  color = vec4(sum / float(evaluations), 0.0);
}
