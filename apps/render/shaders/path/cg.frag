// SPDX-License-Identifier: Apache-2.0
// Examples 5-3 to 5-10 of Randima Fernando and Mark Kilgard 2003, "The Cg Tutorial", for each fragment (path/cg.glsl).
//
// Differences: the examples light in object space, exercise 3 in eye space, this in world space. All give the same
// pixels, because rotations and translations keep dot products and distances; apps/papers has the programs in either
// space, at the vertices. Ka is Kd, the texture, unless the material has its own Ka.

#include "depth_test.glsl"
#include "path/cg.glsl"
#include "fragment.glsl"
#include "listed_lights.glsl"

in vec3 normal;

void main() {
  vec3 p = fragment_position();
  vec3 v = normalize(vector_to_viewer(p));
  vec3 n = normalize(normal);
  vec4 kd = base_texture();
  vec3 ks = specular * kd.a;
  vec3 diffuse_sum = vec3(0.0);
  vec3 specular_sum = vec3(0.0);
  if (has_moon) compute_lighting(moon_direction, moon_color, v, n, diffuse_sum, specular_sum);  // 5.5.3: directional
#define ADD_LIGHT(i) spot_atten_lighting(batch_light(i), p, v, n, diffuse_sum, specular_sum);
  EACH_LIGHT(ADD_LIGHT)
#undef ADD_LIGHT
#define ADD_LIGHT(i) spot_atten_lighting(listed_light(i), p, v, n, diffuse_sum, specular_sum);
  EACH_LISTED_LIGHT(ADD_LIGHT)
#undef ADD_LIGHT
  color = seen_by_eye(emissive + ambient_reflectance(kd.rgb) * ambient_light + kd.rgb * diffuse_sum + ks * specular_sum, p);
}
