// SPDX-License-Identifier: Apache-2.0
// Everything per fragment in world space (Lacroix 2005, "Unified per-pixel lighting solution", listings 2.1 to 2.3), with
// the Cg Tutorial's Basic model and Hales's fog.

#include "litfog/surface.glsl"
#include "litfog/fog.glsl"
#include "local_lights.glsl"

in vec3 rasterised_position;
in vec3 normal;
in vec4 tangent;
in vec2 uv;

uniform vec3 bounds_low;  // of the surface drawn
uniform vec3 bounds_high;
uniform vec3 eye;
uniform vec3 ambient_light;
uniform vec3 moon_direction;
uniform vec3 moon_color;
uniform sampler2D albedo_map;  // rgb reflectance, a gloss
uniform sampler2D normal_map;
uniform float tile_size;  // metres that one tile covers
uniform vec3 specular;
uniform float shininess;
uniform vec3 emissive;
uniform isamplerBuffer light_list;
uniform ivec2 light_list_range;  // first, count: the local lights that can reach this surface

out vec4 color;

void main() {
  // A pixel that a surface covers in part is shaded at its middle, which near the horizon may lie many metres beyond the
  // surface, in reach of other lights.
  vec3 position = clamp(rasterised_position, bounds_low, bounds_high);
  vec2 tile = uv / tile_size;
  vec4 albedo = texture(albedo_map, tile);
  vec3 bump = texture(normal_map, tile).xyz * 2.0 - 1.0;
  vec3 n = normalize(normal);
  vec3 t = normalize(tangent.xyz - n * dot(n, tangent.xyz));
  vec3 b = cross(n, t) * tangent.w;

  Surface surface;
  surface.position = position;
  surface.normal = normalize(t * bump.x + b * bump.y + n * bump.z);
  surface.to_eye = normalize(eye - position);
  surface.emissive = emissive;
  surface.diffuse = albedo.rgb;
  surface.specular = specular * albedo.a;
  surface.shininess = shininess;

  vec3 lit = litfog_ambient(surface, ambient_light) + litfog_reflect(surface, moon_direction, moon_color);
  int carried = int(litfog_fog.z);
  for (int i = 0; i < carried; ++i) lit += litfog_light_surface(surface, litfog_lights[i]);
  for (int i = 0; i < light_list_range.y; ++i) {
    int light = texelFetch(light_list, light_list_range.x + i).x;
    vec4 position_extent = local_light_position_extent(light);
    if (distance(position_extent.xyz, position) > position_extent.w) continue;
    lit += litfog_light_surface(surface, local_light(light));
  }
  color = vec4(litfog_apply_fog(lit, position, eye), 1.0);
}
