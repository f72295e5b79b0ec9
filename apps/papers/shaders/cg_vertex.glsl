// SPDX-License-Identifier: Apache-2.0
// The lighting of path/cg.glsl at the vertices, in a space of the includer's choice (Randima Fernando and Mark Kilgard
// 2003, "The Cg Tutorial", examples 5-1 and 5-4 with attenuation and spots, 5-10). The light's sums are modulated by
// the material's colours at the fragments, which have its texture (path/vertex.frag).

#include "path/cg.glsl"
#include "listed_lights.glsl"
#include "vertex.glsl"

out vec3 diffuse_light;
out vec3 specular_light;

// A light in another space, whose unit is some metres.
LitfogLight carried_into(mat4 space_from_world, float metres, LitfogLight light) {
  light.position_extent.xyz = (space_from_world * vec4(light.position_extent.xyz, 1.0)).xyz;
  light.axis_profile.xyz = normalize(mat3(space_from_world) * light.axis_profile.xyz);
  light.attenuation.y *= metres;
  light.attenuation.z *= metres * metres;
  return light;
}

// p, n, v  position, unit normal and unit vector to the eye, in the space
void light_vertex(mat4 space_from_world, float metres, vec3 p, vec3 n, vec3 v) {
  diffuse_light = vec3(0.0);
  specular_light = vec3(0.0);
  vec3 to_moon = normalize(mat3(space_from_world) * moon_direction);
  if (has_moon) compute_lighting(to_moon, moon_color, v, n, diffuse_light, specular_light);
#define ADD_LIGHT(i) \
  spot_atten_lighting(carried_into(space_from_world, metres, batch_light(i)), p, v, n, diffuse_light, specular_light);
  EACH_LIGHT(ADD_LIGHT)
#undef ADD_LIGHT
#define ADD_LIGHT(i) \
  spot_atten_lighting(carried_into(space_from_world, metres, listed_light(i)), p, v, n, diffuse_light, specular_light);
  EACH_LISTED_LIGHT(ADD_LIGHT)
#undef ADD_LIGHT
}
