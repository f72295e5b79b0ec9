// SPDX-License-Identifier: Apache-2.0
// Everything per fragment in world space (Lacroix 2005, "Unified per-pixel lighting solution", listings 2.1 to 2.3), with
// the Cg Tutorial's Basic model and Hales's fog.

#include "cookie.glsl"
#include "litfog/surface.glsl"
#include "fragment.glsl"
#include "local_lights.glsl"
#include "world_normal.glsl"

void main() {
  vec3 position = fragment_position();
  vec4 albedo = base_texture();

  Surface surface;
  surface.position = position;
  surface.normal = mapped_world_normal();
  surface.to_eye = direction_to_viewer(position);
  surface.emissive = emissive;
  surface.diffuse = albedo.rgb;
  surface.specular = specular * albedo.a;
  surface.shininess = shininess;

  vec3 lit = litfog_ambient(surface, ambient_light) + litfog_reflect(surface, moon_direction, moon_color);
  int carried = int(litfog_fog.z);
  for (int i = 0; i < carried; ++i) lit += litfog_light_surface(surface, litfog_lights[i]);
  for (int i = 0; i < light_list_range.y; ++i) {
    int light = listed_light(i);
    vec4 position_extent = local_light_position_extent(light);
    if (distance(position_extent.xyz, position) > position_extent.w) continue;
    lit += litfog_light_surface(surface, local_light(light));
  }
  color = seen_by_eye(lit, position);
}
