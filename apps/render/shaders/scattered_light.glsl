// SPDX-License-Identifier: Apache-2.0
// The light that fog scatters on a surface, from the grid of render::ScatteredLight.

#include "litfog/shaders/diffuse_light.glsl"

uniform sampler3D scattered_all;
uniform sampler3D scattered_flow;
uniform float scattered_depth;  // metres along a ray that the grid covers; 0: none
uniform vec2 picture_size;

vec3 scattered_irradiance(vec3 position, vec3 normal) {
  if (!has_scattered_light || scattered_depth <= 0.0) return vec3(0.0);
  vec3 place = vec3(gl_FragCoord.xy / picture_size, pow(distance(position, eye) / scattered_depth, 1.0 / 3.0));
  vec4 flow = texture(scattered_flow, place);
  float irradiance = litfog_diffuse_irradiance(flow.w, length(flow.xyz), -dot(flow.xyz, normal));
  return texture(scattered_all, place).rgb * (irradiance / max(flow.w, 1.0e-30));
}
