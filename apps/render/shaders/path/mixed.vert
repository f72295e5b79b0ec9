// SPDX-License-Identifier: Apache-2.0
// Randima Fernando and Mark Kilgard 2003, "The Cg Tutorial", chapter 5, exercise 6: "Compute the emissive, ambient, and
// diffuse contributions in the vertex program. Also, compute the half-angle and normal vectors in the vertex program".
// Differences: emissive and ambient light are added at the fragments, which have the texture; a light's
// attenuation and cone are interpolated beside its half-angle vector. There are interpolated values for a few lights
// only, so more lights add their highlights in more passes.

#include "path/diffuse.glsl"
#include "listed_lights.glsl"
#include "scene.glsl"
#include "vertex.glsl"

out vec3 diffuse_light;  // sum over all lights
out vec3 normal;
out vec3 half_angle[batch_size];
out vec3 specular_light[batch_size];  // at gloss 1 and a facing of 1; 0 where the diffuse term is
out vec3 moon_half_angle;
out vec3 moon_specular_light;

void main() {
  vec3 position = place_vertex();
  vec3 to_eye = normalize(vector_to_viewer(position));
  normal = world_normal();
  diffuse_light = vec3(0.0);
  if (is_first_pass) {
    float facing = max(dot(normal, moon_direction), 0.0);
    moon_half_angle = normalize(moon_direction + to_eye);
    moon_specular_light = facing > 0.0 ? moon_color : vec3(0.0);
    diffuse_light = moon_color * facing;
  }
  for (int i = 0; i < lights_in_pass; ++i) {
    LitfogLight light = batch_light(i);
    vec4 ray = litfog_ray(light.position_extent.xyz, position);
    half_angle[i] = normalize(to_eye - ray.xyz);
    specular_light[i] = dot(normal, ray.xyz) < 0.0 ? litfog_light_along(light, ray) : vec3(0.0);
    if (is_first_pass && !has_listed_lights) diffuse_light += diffuse_reflection(light, position, normal);
  }
#define ADD_LIGHT(i) diffuse_light += diffuse_reflection(listed_light(i), position, normal);
  EACH_LISTED_LIGHT(ADD_LIGHT)
#undef ADD_LIGHT
}
