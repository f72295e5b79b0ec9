// SPDX-License-Identifier: Apache-2.0
// The sample program of Steven Hales 2004, "Realtime Pixel Lighting Using Fragment Programs", section "Sample Fragment
// Program", line by line: two headlights of the same parameters, "close enough together that the same range attenuation
// value can be used for both", the light's colour as its ambient colour, saturating arithmetic; with the section
// "Lighting in Fog", as for his figure 2.
//
// As printed, the texture coordinates are declared as tc_t1 and tc_t2, but used as tc_t0 and tc_t1. Registers here:
// tc_f, which he has as one number, holds the environment's colours; icol is the vertices' colour, which
// first_texture() includes; a surface without a second texture has a white one. (Two face textures and the cube map
// leave one of a card's four texture units, so the program takes its range from the 3-D map.) The fog is the scene's,
// not always exp2.
//
// "The polygons within the extent of the light (and within the cone angle) can be sorted from those outside": for table
// 1 `litfog-demo papers` draws the program over all polygons, and over a scene sorted by render::sort_polygons.
//
// Other lights than two alike are drawn in more passes, as in lookup.glsl. Two lights that are not close together,
// which no printed line forbids, both take the range of the first.

#include "depth_test.glsl"
#include "path/light_coordinates.glsl"
#include "path/map_coordinate.glsl"

uniform sampler3D range_map;
uniform samplerCube cone_map;

vec3 saturate(vec3 color) { return clamp(color, 0.0, 1.0); }

void main() {
  vec3 tc_f = is_first_pass ? directional_light(directional_shade) : vec3(0.0);
  vec3 tex1 = first_texture().rgb;                                                   // TXP tex1
  vec3 tex2 = second_texture();                                                      // TXP tex2
  float ra = 0.0;
  float aa = 0.0;
  vec3 lcol = vec3(0.0);
  float fog_intensity = 0.0;
  if (lights_in_pass > 0) {
    ra = texture(range_map, map_coordinate(range_coordinate(0), textureSize(range_map, 0).x)).r;  // TEX ra
    for (int i = 0; i < lights_in_pass; ++i) aa += texture(cone_map, cone_coordinate(i)).r;  // TEX aa1, TEX aa2, ADD aa
    lcol = batch_light(0).color_intensity.rgb;
    fog_intensity = batch_light(0).color_intensity.w;
  }
  vec3 acc = vec3(aa * ra);              // MUL acc, aa, ra
  acc = saturate(acc * lcol + tc_f);     // MAD_SAT acc.xyz, acc, lcol, tc_f.x
  acc = acc * tex1;                      // MUL acc, acc, tex1
  acc = acc * tex2;                      // MUL acc, acc, tex2
  vec3 before_fog = saturate(acc);       // MUL_SAT output, acc, icol
  vec3 fog = lcol * (aa * fog_intensity);  // "light color * angle attenuation * fog color intensity"
  if (is_first_pass) fog += litfog_ambient_fog_color.rgb;
  color = vec4(mix(before_fog, fog, opacity_before(fragment_position())), 1.0);
}
