// SPDX-License-Identifier: Apache-2.0
// The airlight of one light along the ray through each pixel, to what the pixel's samples see.

#include "cookie.glsl"
#include "fog_top.glsl"
#include "light_list.glsl"
#include "litfog/shaders/glow.glsl"

flat in int light_index;

uniform sampler2DMS depths;
uniform int sample_count;
uniform vec2 pixel_size;  // 2 over the picture's size: of a pixel in clip space
uniform mat4 direction_from_clip;
uniform vec3 eye;
uniform vec3 forward;      // unit: the camera's axis
uniform float near_plane;  // metres
uniform float asymmetry;

out vec4 color;

void main() {
  vec4 seen = direction_from_clip * vec4(gl_FragCoord.xy * pixel_size - 1.0, 0.0, 1.0);
  vec3 direction = normalize(seen.xyz / seen.w);
  float ranges[4];
  float nearest = 3.4e38;
  float farthest = 0.0;
  float mean = 0.0;
  for (int i = 0; i < sample_count; ++i) {
    float depth = texelFetch(depths, ivec2(gl_FragCoord.xy), i).r;  // 1 - near / distance along the axis
    ranges[i] = depth < 1.0 ? near_plane / ((1.0 - depth) * dot(direction, forward)) : fog_before_sky(direction);
    nearest = min(nearest, ranges[i]);
    farthest = max(farthest, ranges[i]);
    mean += ranges[i] / float(sample_count);
  }
  LitfogLight light = litfog_buffered_light(light_index);
  // Over a surface's slope the airlight is straight; at its edge each sample has its own.
  bool is_edge = farthest > 1.1 * nearest;
  int evaluations = is_edge ? sample_count : 1;
  vec3 sum = vec3(0.0);
  for (int i = 0; i < evaluations; ++i) {
    sum += litfog_glow(light, eye, direction, is_edge ? ranges[i] : mean, 1.0, asymmetry);
  }
  color = vec4(sum / float(evaluations), 0.0);
}
