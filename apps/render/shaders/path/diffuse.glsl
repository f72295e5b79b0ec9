// SPDX-License-Identifier: Apache-2.0
// The diffuse term of a light at a vertex (Randima Fernando and Mark Kilgard 2003, "The Cg Tutorial", section 5.2):
// incident light times N.L.

#include "cookie.glsl"
#include "litfog/shaders/light.glsl"

vec3 diffuse_reflection(LitfogLight light, vec3 position, vec3 normal) {
  vec4 ray = litfog_ray(light.position_extent.xyz, position);
  return litfog_light_along(light, ray) * max(-dot(normal, ray.xyz), 0.0);
}
