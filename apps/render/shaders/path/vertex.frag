// SPDX-License-Identifier: Apache-2.0
// The vertices' light on the material (Randima Fernando and Mark Kilgard 2003, "The Cg Tutorial", example 5-4:
// "modulate diffuse and specular by material color"). Emissive and ambient light is added here too, because only
// fragments have the material's texture and gloss.

#include "depth_test.glsl"
#include "fragment.glsl"

in vec3 diffuse_light;
in vec3 specular_light;

// Ambient and diffuse light reflected by a base colour.
vec3 reflected(vec3 base) {
#ifdef MATERIAL_AMBIENT
  return ambient_reflectance(base) * ambient_light + base * vertex_light(diffuse_light);
#else
  return base * (ambient_light + vertex_light(diffuse_light));
#endif
}

void main() {
  vec4 albedo = base_texture();
  vec3 lit = emissive + reflected(albedo.rgb) + specular * albedo.a * vertex_light(specular_light);
  color = seen_by_eye(lit, fragment_position());
}
