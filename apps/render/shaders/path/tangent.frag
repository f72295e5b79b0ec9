// SPDX-License-Identifier: Apache-2.0
// Jason Lacroix 2005, "Let There Be Light!: A Unified Lighting Technique for a New Generation of Games", listing 1.2,
// PixelShader.psh: the map's normal as it is, and the loop that adds up the lights. Differences: each light has the
// Basic model's terms, clamped to 0, its own attenuation instead of 1/dist, and a cone (lit_surface.glsl); the normal
// is normalised.

#include "depth_test.glsl"
#include "lit_surface.glsl"
#include "light_batch.glsl"

in vec3 to_viewer;
in vec3 to_moon;
in vec3 to_light[batch_size];
in vec3 light_axis[batch_size];
#ifdef LITFOG_COOKIES
in vec3 cookie_up[batch_size];
#endif

void main() {
  vec4 albedo = base_texture();
  LitfogSurface surface =
      LitfogSurface(vec3(0.0), normalize(mapped_normal()), normalize(to_viewer), emissive,
                    ambient_reflectance(albedo.rgb), albedo.rgb, specular * albedo.a, shininess);

  vec3 lit = vec3(0.0);
  if (is_first_pass) {
    lit = litfog_ambient(surface, ambient_light);
    if (has_moon) lit += moon_factor() * litfog_reflect(surface, normalize(to_moon), moon_color);
  }
  for (int i = 0; i < lights_in_pass; ++i) {
    LitfogLight light = batch_light(i);
    light.position_extent.xyz = to_light[i];
    light.axis_profile.xyz = normalize(light_axis[i]);
#ifdef LITFOG_COOKIES
    if (light.axis_profile.w == LITFOG_PROFILE_COOKIE) light.cone.yzw = normalize(cookie_up[i]);
#endif
    lit += lamp_shadow(i) * lit_by(surface, light);
  }
  color = seen_by_eye(lit, fragment_position());
}
