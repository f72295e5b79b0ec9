// SPDX-License-Identifier: Apache-2.0
// litfog: the Cg Tutorial's Basic model (chapter 5.2): emissive + ambient + sum over lights of diffuse + specular,
// specular zero where diffuse is; attenuated by range (5.5.1) and cone (5.5.2, 5.5.3).

#include "litfog/light.glsl"

struct Surface {
  vec3 position;
  vec3 normal;  // unit
  vec3 to_eye;  // unit
  vec3 emissive;
  vec3 diffuse;  // also the ambient reflectance
  vec3 specular;
  float shininess;
};

vec3 litfog_ambient(Surface surface, vec3 ambient_light) { return surface.emissive + surface.diffuse * ambient_light; }

// Light of a colour from a unit direction.
vec3 litfog_reflect(Surface surface, vec3 to_light, vec3 color) {
  float diffuse = dot(surface.normal, to_light);
  if (diffuse <= 0.0) return vec3(0.0);
  float facing = max(dot(surface.normal, normalize(to_light + surface.to_eye)), 0.0);
  return color * (surface.diffuse * diffuse + surface.specular * pow(facing, surface.shininess));
}

vec3 litfog_light_surface(Surface surface, FogLight light) {
  float range = distance(surface.position, light.position_extent.xyz);
  if (range > light.position_extent.w) return vec3(0.0);
  vec3 to_light = litfog_direction(surface.position, light.position_extent.xyz);
  float strength = litfog_cone(light, -to_light);
  if (strength <= 0.0) return vec3(0.0);
  return litfog_reflect(surface, to_light, light.color_intensity.rgb * (strength * litfog_range(light, range)));
}
