// SPDX-License-Identifier: Apache-2.0
// The lighting of Randima Fernando and Mark Kilgard 2003, "The Cg Tutorial", chapter 5, as its examples 5-5 to 5-10
// print it, for vertices or fragments, in any space. Attenuation is neither clamped to 1 nor cut at an extent. A
// spotlight's edge is hard (5-8), or linear (the text's lerp) or smooth (5-9) between its two cones. The other paths
// clamp and cut (litfog/shaders/surface.glsl), so that no light is brighter than its colour and each ends somewhere.

#include "cookie.glsl"
#include "litfog/shaders/light.glsl"
#include "scene.glsl"

// The specular colour of a light: its diffuse colour, unless a program redefines it.
#ifndef specular_color
#define specular_color(diffuse_color) (diffuse_color)
#endif

float c5e6_attenuation(vec3 p, LitfogLight light) {
  float d = distance(p, light.position_extent.xyz);
  return 1.0 / (light.attenuation.x + light.attenuation.y * d + light.attenuation.z * d * d);
}

float spotlight(vec3 p, LitfogLight light) {
  if (!litfog_has_cone(light.axis_profile.w)) return 1.0;
  vec3 v = normalize(p - light.position_extent.xyz);
  float cos_direction = dot(v, light.axis_profile.xyz);
  float cos_outer_cone = light.cone.x;
  if (litfog_cone_is_cut_off(light.axis_profile.w) || spot_edge == spot_edge_hard) {  // C5E8_spotlight
    return cos_outer_cone <= cos_direction ? 1.0 : 0.0;
  }
  float cos_inner_cone = light.cone.y;
  if (spot_edge == spot_edge_lerp) {
    return clamp((cos_direction - cos_outer_cone) / (cos_inner_cone - cos_outer_cone), 0.0, 1.0);
  }
  return smoothstep(cos_outer_cone, cos_inner_cone, cos_direction);  // C5E9_dualConeSpotlight
}

// C5E5_computeLighting
void compute_lighting(vec3 l, vec3 light_color, vec3 v, vec3 n, inout vec3 diffuse_sum, inout vec3 specular_sum) {
  float diffuse_light = max(dot(n, l), 0.0);
  vec3 h = normalize(l + v);
  float specular_light = pow(max(dot(n, h), 0.0), shininess);
  if (diffuse_light <= 0.0) specular_light = 0.0;
  diffuse_sum += light_color * diffuse_light;
  specular_sum += specular_color(light_color) * specular_light;
}

// C5E10_spotAttenLighting
void spot_atten_lighting(LitfogLight light, vec3 p, vec3 v, vec3 n, inout vec3 diffuse_sum, inout vec3 specular_sum) {
  float attenuation_factor = c5e6_attenuation(p, light);
  float spot_effect = spotlight(p, light);
  vec3 l = normalize(light.position_extent.xyz - p);
  compute_lighting(l, attenuation_factor * spot_effect * light.color_intensity.rgb, v, n, diffuse_sum, specular_sum);
}
