// SPDX-License-Identifier: Apache-2.0
// The lighting of Randima Fernando and Mark Kilgard 2003, "The Cg Tutorial", chapter 5, as its examples 5-3 to 5-10
// print it, for each fragment: attenuation is neither clamped to 1 nor cut at an extent, and a spotlight's edge is hard
// (5-8), or between its two cones linear (the text's lerp) or smooth (5-9). The other paths clamp and cut
// (litfog/shaders/surface.glsl), so that no light is brighter than its colour and each ends somewhere.
//
// Where this leaves them: the examples light in object space, exercise 3 in eye space, this in world space. No pixel
// would differ, because rotations and translations keep dot products and distances. (An object scaled by s is the
// exception: in its own space distances are in units of s metres, so the application has to scale kL and kQ, too.) Eye
// space saves the eye's position, which there is the origin. Ka is Kd, the
// texture, but for a material with a Ka of its own.

#include "depth_test.glsl"
#include "cookie.glsl"
#include "litfog/shaders/surface.glsl"
#include "fragment.glsl"
#include "listed_lights.glsl"

in vec3 normal;

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
void compute_lighting(vec3 l, vec3 light_color, vec3 p, vec3 n, inout vec3 diffuse_sum, inout vec3 specular_sum) {
  float diffuse_light = max(dot(n, l), 0.0);
  vec3 v = normalize(vector_to_viewer(p));
  vec3 h = normalize(l + v);
  float specular_light = pow(max(dot(n, h), 0.0), shininess);
  if (diffuse_light <= 0.0) specular_light = 0.0;
  diffuse_sum += light_color * diffuse_light;
  specular_sum += light_color * specular_light;
}

// C5E10_spotAttenLighting
void spot_atten_lighting(LitfogLight light, vec3 p, vec3 n, inout vec3 diffuse_sum, inout vec3 specular_sum) {
  float attenuation_factor = c5e6_attenuation(p, light);
  float spot_effect = spotlight(p, light);
  vec3 l = normalize(light.position_extent.xyz - p);
  compute_lighting(l, attenuation_factor * spot_effect * light.color_intensity.rgb, p, n, diffuse_sum, specular_sum);
}

void main() {
  vec3 p = fragment_position();
  vec3 n = normalize(normal);
  vec4 kd = base_texture();
  vec3 ks = specular * kd.a;
  vec3 diffuse_sum = vec3(0.0);
  vec3 specular_sum = vec3(0.0);
  if (has_moon) compute_lighting(moon_direction, moon_color, p, n, diffuse_sum, specular_sum);  // 5.5.3: directional
#define ADD_LIGHT(i) spot_atten_lighting(batch_light(i), p, n, diffuse_sum, specular_sum);
  EACH_LIGHT(ADD_LIGHT)
#undef ADD_LIGHT
#define ADD_LIGHT(i) spot_atten_lighting(listed_light(i), p, n, diffuse_sum, specular_sum);
  EACH_LISTED_LIGHT(ADD_LIGHT)
#undef ADD_LIGHT
  color = seen_by_eye(emissive + ambient_reflectance(kd.rgb) * ambient_light + kd.rgb * diffuse_sum + ks * specular_sum, p);
}
