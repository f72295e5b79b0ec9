// SPDX-License-Identifier: Apache-2.0
// The Basic model at the vertices, any number of lights: Randima Fernando and Mark Kilgard 2003, "The Cg Tutorial",
// examples 5-4 (C5E4v_twoLights: the loop, the sums of diffuse and specular light) and 5-10 (C5E10_spotAttenLighting);
// Jason Lacroix 2005, "Let There Be Light!: A Unified Lighting Technique for a New Generation of Games", listing 1.1
// (the loop over the lights, in world space). Light is interpolated between vertices, so a spot of light inside a
// triangle is lost.
//
// Differences: attenuation is clamped to 1 and ends at the extent (cg.frag has it as printed); N.L is
// clamped to 0 (lacroix.frag has it as printed); lighting is in world space (cg.frag says why object and eye space look
// the same); the material's colours are applied at the fragments. Lacroix casts the world matrix to 3x3, which leaves
// out its translation, and projects the vertex without that matrix: his objects stand unrotated at the origin.

#include "cookie.glsl"
#include "litfog/shaders/surface.glsl"
#include "listed_lights.glsl"
#include "scene.glsl"
#include "vertex.glsl"

out vec3 diffuse_light;
out vec3 specular_light;

void add_light(LitfogLight light, vec3 position, vec3 normal, vec3 to_eye) {
  vec4 ray = litfog_ray(light.position_extent.xyz, position);
  vec3 arriving = litfog_light_along(light, ray);
  vec2 factors = litfog_reflection_factors(normal, to_eye, shininess, -ray.xyz);
  diffuse_light += arriving * factors.x;
  specular_light += arriving * factors.y;
}

void main() {
  vec3 position = place_vertex();
  vec3 normal = world_normal();
  vec3 to_eye = normalize(vector_to_viewer(position));
  vec2 factors = litfog_reflection_factors(normal, to_eye, shininess, moon_direction);
  diffuse_light = moon_color * factors.x;
  specular_light = moon_color * factors.y;
#define ADD_LIGHT(i) add_light(batch_light(i), position, normal, to_eye);
  EACH_LIGHT(ADD_LIGHT)
#undef ADD_LIGHT
#define ADD_LIGHT(i) add_light(listed_light(i), position, normal, to_eye);
  EACH_LISTED_LIGHT(ADD_LIGHT)
#undef ADD_LIGHT
}
