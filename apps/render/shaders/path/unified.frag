// SPDX-License-Identifier: Apache-2.0
// Jason Lacroix 2005, "Let There Be Light!: A Unified Lighting Technique for a New Generation of Games", section
// "Unified per-pixel lighting solution": listing 2.1, the loop over the lights in world space, and listing 2.3, the
// normal map's normal in world space (world_normal.glsl). interpolated.frag has listing 2.2.
//
// Differences: each light has the Basic model's terms (litfog/shaders/surface.glsl), clamped to 0, its own
// attenuation instead of 1/dist, and a cone; Hales's fog lies before the surface. His constant registers, 224, were the
// limit of his lights; here it is kMaxUniformLights (shader_variant.h), and more are read from a buffer.
//
// A shader is compiled for its number of lights, and the loop over a light list ends with the list; nested.frag has his
// nested ifs instead (listings 3.1 and 3.2). object_space.frag has normal maps in object space, parallax.frag parallax
// mapping, lacroix.frag his equations without clamp and end. "Early rejection is key": on llvmpipe a depth pass pays
// only with many lights and one sample a pixel, sorting from front to back hardly ever (EarlyRejection;
// docs/performance.md). So surfaces stay sorted by material.

#include "depth_test.glsl"
#include "lit_surface.glsl"
#include "listed_lights.glsl"
#include "scattered_light.glsl"
#include "world_normal.glsl"

void main() {
  vec3 position = fragment_position();
  vec4 albedo = base_texture();
  LitfogSurface surface =
      LitfogSurface(position, mapped_world_normal(), normalize(vector_to_viewer(position)), emissive,
                    ambient_reflectance(albedo.rgb), albedo.rgb, specular * albedo.a, shininess);

  vec3 lit = litfog_ambient(surface, ambient_light) + surface.diffuse * scattered_irradiance(position, surface.normal);
  if (has_moon) lit += moon_factor() * litfog_reflect(surface, moon_direction, moon_color);
#define ADD_LIGHT(i) lit += lamp_shadow(i) * lit_by(surface, batch_light(i));
  EACH_LIGHT(ADD_LIGHT)
#undef ADD_LIGHT
#define ADD_LIGHT(i) \
  if (is_out_of_reach(i, position, surface.normal, are_lit_beyond_ends ? reach : 1.0)) continue; \
  lit += listed_lamp_shadow(listed_entry(i)) * lit_by(surface, listed_light(i));
  EACH_LISTED_LIGHT(ADD_LIGHT)
#undef ADD_LIGHT
  color = seen_by_eye(lit, position);
}
