// SPDX-License-Identifier: Apache-2.0
// Steven Hales 2004, "Realtime Pixel Lighting Using Fragment Programs". By section:
//
// "Fragment Program Lighting Equations": (sum of range attenuation * angle attenuation * (ambient light colour + (I .
// N) * diffuse light colour) + directional ambient + directional diffuse * (d . n)) * face fragment colour * face
// texture 1 * face texture 2 (if any). Here I is the direction from the fragment to the light. His own I, "the
// direction of the light", is the spot's axis: with it a level headlight would not light the road at all. A light's
// ambient colour is a fraction of its diffuse colour. base_texture() is the product of the face's colour and textures.
//
// "Lighting in Fog": fragment fog colour = light colour * angle attenuation * fog colour intensity + ambient fog
// colour. The angle attenuation is the same look-up as the surface's. The sky, which here is no polygon, takes it from
// the formula (sky.frag).
//
// Left out: clamping to 1 before the screen, which his sample program has (sample.frag). Added: more passes for more
// than four lights or for lights with other maps, each with the fog of its own lights; the surface's emission.

#include "path/light_coordinates.glsl"
#include "path/map_coordinate.glsl"

uniform samplerCube cone_map;
uniform bool is_flat_shaded;

float range_attenuation(vec3 str);  // from the path's own map

// "If flat shading is active ... n is the face normal"; otherwise the vertices' shading value, interpolated.
float shading_value() {
  if (!is_flat_shaded) return directional_shade;
  return dot(moon_direction, normalize(cross(dFdx(rasterised_position), dFdy(rasterised_position))));
}

void main() {
  vec3 n = normalize(normal);
  vec3 light = is_first_pass ? directional_light(shading_value()) : vec3(0.0);
  vec3 fog = is_first_pass ? litfog_ambient_fog_color.rgb : vec3(0.0);
  for (int i = 0; i < lights_in_pass; ++i) {
    vec4 ray = litfog_ray(vector_from_light(i), vec3(0.0));
    vec4 color_intensity = batch_light(i).color_intensity;
    float ra = range_attenuation(range_coordinate(i));
    float aa = texture(cone_map, cone_coordinate(i)).r;
    light += ra * aa * (light_ambient + max(dot(ray.xyz, n), 0.0)) * color_intensity.rgb *
             lamp_factor(batch_light(i), fragment_position().y, ray.w) * lamp_shadow(i);
    fog += aa * color_intensity.rgb * color_intensity.w;
  }
  vec3 lit = light * base_texture().rgb;
  if (is_first_pass) lit += emissive;
  vec3 seen = mix(lit, fog, opacity_before(fragment_position()));
  if (is_first_pass) seen += moon_airlight_before(fragment_position());
  color = vec4(seen, 1.0);
}
