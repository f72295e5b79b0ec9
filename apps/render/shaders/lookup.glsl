// SPDX-License-Identifier: Apache-2.0
// Steven Hales 2004, "Realtime Pixel Lighting Using Fragment Programs", section "Fragment Program Lighting Equations":
// (sum of range attenuation * angle attenuation * (L . N) * light colour + directional ambient + directional diffuse *
// (d . n)) * face texture, then fog. No specular, no normal map. A light has no ambient term of its own here, nothing
// is clamped to 1 before the screen, and the lit fog's cone comes from the formula.

#include "light_coordinates.glsl"
#include "map_coordinate.glsl"

uniform samplerCube cone_map;
uniform bool is_flat_shaded;

float range_attenuation(vec3 str);  // from the path's own map

// "If flat shading is active ... n is the face normal"; else the vertices' shading value, interpolated.
float shading_value() {
  if (!is_flat_shaded) return directional_shade;
  return dot(moon_direction, normalize(cross(dFdx(rasterised_position), dFdy(rasterised_position))));
}

void main() {
  vec3 n = normalize(normal);
  vec3 light = vec3(0.0);
  for (int i = 0; i < lights_in_pass; ++i) {
    vec4 ray = litfog_ray(vector_from_light(i), vec3(0.0));
    float ra = range_attenuation(range_coordinate(i));
    float aa = texture(cone_map, cone_coordinate(i)).r;
    light += ra * aa * max(dot(ray.xyz, n), 0.0) * batch_light(i).color_intensity.rgb *
             lamp_factor(batch_light(i), ray.w) * lamp_shadow(i);
  }
  if (is_first_pass) light += directional_light(shading_value());
  vec3 lit = light * base_texture().rgb;
  if (is_first_pass) lit += emissive;
  color = seen_by_eye(lit, fragment_position());
}
