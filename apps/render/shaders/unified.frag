// SPDX-License-Identifier: Apache-2.0
// Everything per fragment in world space, with the Cg Tutorial's Basic model and Hales's fog (Jason Lacroix 2005, "Let
// There Be Light!: A Unified Lighting Technique for a New Generation of Games", section "Unified per-pixel lighting
// solution", listings 2.1 to 2.3).

#define CONSTANTS_FROM_VERTICES
#include "lit_surface.glsl"
#include "listed_lights.glsl"
#include "world_normal.glsl"

void main() {
  vec3 position = fragment_position();
  vec4 albedo = base_texture();

  LitfogSurface surface;
  surface.position = position;
  surface.normal = mapped_world_normal();
  surface.to_eye = normalize(vector_to_viewer(position));
  surface.emissive = emissive;
  surface.diffuse = albedo.rgb;
  surface.specular = specular * albedo.a;
  surface.shininess = shininess;

  vec3 lit = litfog_ambient(surface, ambient_light);
  if (has_moon) lit += litfog_reflect(surface, moon_direction, moon_color);
#define ADD_LIGHT(i) lit += lamp_shadow(i) * lit_by(surface, batch_light(i));
  EACH_LIGHT(ADD_LIGHT)
#undef ADD_LIGHT
  for (int i = 0; i < listed_light_count(); ++i) {
    if (is_out_of_reach(i, position)) continue;
    lit += listed_lamp_shadow(listed_entry(i)) * lit_by(surface, listed_light(i));
  }
  color = seen_by_eye(lit, position);
}
