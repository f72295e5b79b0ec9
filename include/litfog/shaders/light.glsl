// SPDX-License-Identifier: Apache-2.0
// litfog: lights and fog as the parameter block holds them (litfog/fog_light_block.h). World space, metres.

#include "litfog/expm1.glsl"
#include "litfog/formulas.glsl"

const int LITFOG_MAX_LIGHTS = 128;

struct FogLight {
  vec4 position_extent;  // xyz position, w extent
  vec4 axis_profile;     // xyz unit axis, w profile: 0 none, 1 cosine, 2 smoothstep, 3 the includer's
  vec4 color_intensity;  // rgb colour, w fog colour intensity
  vec4 attenuation;      // x constant, y linear, z quadratic, w density scale
  vec4 cone;             // cosine: x cos half angle, y exponent; smoothstep: x cos outer, y cos inner
};

layout(std140) uniform FogLightBlock {
  vec4 litfog_fog;  // x density, y mode: 0 exp, 1 exp2, z number of lights
  vec4 litfog_ambient_fog_color;
  FogLight litfog_lights[LITFOG_MAX_LIGHTS];
};

// A ray from one point to another: xyz its unit direction, w its length. Where they are the same the direction is 0, to
// which no cone and no surface is turned.
vec4 litfog_ray(vec3 from, vec3 to) {
  vec3 offset = to - from;
  float range = length(offset);
  return vec4(range > 0.0 ? offset * (1.0 / range) : vec3(0.0), range);
}

#ifdef LITFOG_COOKIES  // the includer has lights of a shape of its own, profile 3, whose cone means what it likes
float litfog_cookie(FogLight light, vec3 direction);
#endif

// Share of the axial intensity towards a direction (unit, from the light).
float litfog_cone(FogLight light, vec3 direction) {
  float cos_angle = dot(light.axis_profile.xyz, direction);
  if (light.axis_profile.w == 1.0) return litfog_cosine_cone(cos_angle, light.cone.x, light.cone.y);
  if (light.axis_profile.w == 2.0) return litfog_smoothstep_cone(cos_angle, light.cone.y, light.cone.x);
#ifdef LITFOG_COOKIES
  if (light.axis_profile.w == 3.0) return litfog_cookie(light, direction);
#endif
  return 1.0;
}

// Range attenuation before the extent; a light is dark beyond it (Hales 2004, borders of the range map).
float litfog_range(FogLight light, float range) {
  if (range > light.position_extent.w) return 0.0;
  return litfog_attenuation(range, light.attenuation.x, light.attenuation.y, light.attenuation.z);
}

// What of a light arrives at the end of a ray from it: colour * cone * range attenuation. Without branches, which cost
// some drivers more than what they leave out; whoever draws leaves lights out that do not reach.
vec3 litfog_light_along(FogLight light, vec4 ray) {
  return light.color_intensity.rgb * (litfog_cone(light, ray.xyz) * litfog_range(light, ray.w));
}
