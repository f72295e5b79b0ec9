// SPDX-License-Identifier: Apache-2.0
// "Compute just the specular contribution using the interpolated half-angle and normal vectors" (Randima Fernando and
// Mark Kilgard 2003, "The Cg Tutorial", chapter 5, exercise 6).

#include "depth_test.glsl"
#include "fragment.glsl"

in vec3 diffuse_light;
in vec3 normal;
in vec3 half_angle[batch_size];
in vec3 specular_light[batch_size];
in vec3 moon_half_angle;
in vec3 moon_specular_light;

vec3 highlight(vec3 half_vector, vec3 light) {
  return vertex_light(light) * pow(max(dot(normalize(normal), normalize(half_vector)), 0.0), shininess);
}

void main() {
  vec4 albedo = base_texture();
  vec3 lit = albedo.rgb * vertex_light(diffuse_light);
  vec3 highlights = vec3(0.0);
  if (is_first_pass) {
    lit += emissive + ambient_reflectance(albedo.rgb) * ambient_light;
    highlights = highlight(moon_half_angle, moon_specular_light);
  }
  for (int i = 0; i < lights_in_pass; ++i) highlights += highlight(half_angle[i], specular_light[i]);
  color = seen_by_eye(lit + specular * albedo.a * highlights, fragment_position());
}
