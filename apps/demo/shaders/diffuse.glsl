// SPDX-License-Identifier: Apache-2.0
// The diffuse term of a light at a vertex (Cg Tutorial 5.2): what arrives of it times N.L.

#include "cookie.glsl"
#include "litfog/light.glsl"

vec3 diffuse_reflection(FogLight light, vec3 position, vec3 normal) {
  vec3 to_light = litfog_direction(position, light.position_extent.xyz);
  return litfog_light_at(light, position) * max(dot(normal, to_light), 0.0);
}
