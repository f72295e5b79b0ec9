// SPDX-License-Identifier: Apache-2.0
// Ronald Frazier 2000, "Real-Time Per-Pixel Point Lights and Spot Lights in OpenGL", section "Improvements": "One option
// is to incorporate some type of bump mapping ... Another option would be to encorporate gloss maps and specular
// highlights." He prints no line of either. The light of path/radial.glsl falls on the normal map's normal by N.L, and
// has the Basic model's highlights, scaled by the base texture's gloss.

#include "depth_test.glsl"
#include "path/radial.glsl"

in vec4 tangent;

void main() {
  vec4 base = base_texture();
  vec3 bump = mapped_normal();
  vec3 t = normalize(tangent.xyz);
  vec3 n = normalize(t * bump.x + cross(normal, t) * tangent.w * bump.y + normalize(normal) * bump.z);
  vec3 v = normalize(eye - fragment_position());
  vec3 lit = is_first_pass ? emissive + base.rgb * directional_light(dot(n, moon_direction)) : vec3(0.0);
  for (int i = 0; i < lights_in_pass; ++i) {
    vec3 l = -normalize(vector_from_light(i));
    float facing = dot(n, l);
    if (facing <= 0.0) continue;
    float highlight = pow(max(dot(n, normalize(l + v)), 0.0), shininess);
    lit += radial_light(i) * (base.rgb * facing + specular * base.a * highlight);
  }
  color = seen_by_eye(lit, fragment_position());
}
