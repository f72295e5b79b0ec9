// SPDX-License-Identifier: Apache-2.0
// litfog: a light, and how much of its light arrives at a point. World space, metres.
//
// Lights are in two tables, kinds and instances (litfog/fog_light_block.h). light_block.glsl reads them from a uniform
// block, light_buffer.glsl from textures or storage buffers. A program may use both, or fill a LitfogLight itself.
//
// LITFOG_COOKIES, defined before the first include of litfog, enables LITFOG_PROFILE_COOKIE. The including program then
// defines litfog_cookie(), and litfog_cookie_cone(), which fills the light's cone field for it.

#ifndef LITFOG_LIGHT_GLSL
#define LITFOG_LIGHT_GLSL

#include "litfog/shaders/cone_profile.glsl"
#include "litfog/shaders/formulas.glsl"

// The values that lights of a kind share.
struct LitfogKind {
  vec4 attenuation_extent;    // x constant, y linear, z quadratic, w extent
  vec4 cone_scale_intensity;  // xy cone, z density scale, w fog colour intensity
};

struct LitfogInstance {
  vec4 position_kind;  // xyz position, w index of its kind
  vec4 axis_profile;   // xyz unit axis, w profile: LITFOG_PROFILE_*
  vec4 color;          // rgb colour; w belongs to the including program for LITFOG_PROFILE_COOKIE
};

// An instance with its kind.
struct LitfogLight {
  vec4 position_extent;
  vec4 axis_profile;
  vec4 color_intensity;
  vec4 attenuation;  // x constant, y linear, z quadratic, w density scale
  vec4 cone;         // xy the profile's (cone_profile.glsl); of LITFOG_PROFILE_COOKIE the including program's
};

#ifdef LITFOG_COOKIES
// The cone field of a light of LITFOG_PROFILE_COOKIE, from its instance's color.w.
vec4 litfog_cookie_cone(float cookie);
#endif

LitfogLight litfog_light(LitfogInstance instance, LitfogKind kind) {
  vec4 cone = vec4(kind.cone_scale_intensity.xy, 0.0, 0.0);
#ifdef LITFOG_COOKIES
  if (instance.axis_profile.w == LITFOG_PROFILE_COOKIE) cone = litfog_cookie_cone(instance.color.w);
#endif
  return LitfogLight(vec4(instance.position_kind.xyz, kind.attenuation_extent.w), instance.axis_profile,
                     vec4(instance.color.rgb, kind.cone_scale_intensity.w),
                     vec4(kind.attenuation_extent.xyz, kind.cone_scale_intensity.z), cone);
}

// A ray from one point to another: xyz unit direction, w length. Between equal points the direction is 0, which no cone
// and no surface faces.
vec4 litfog_ray(vec3 from, vec3 to) {
  vec3 offset = to - from;
  float range = length(offset);
  return vec4(range > 0.0 ? offset * (1.0 / range) : vec3(0.0), range);
}

#ifdef LITFOG_COOKIES
// Fraction of the axial intensity in a unit direction from the light.
float litfog_cookie(LitfogLight light, vec3 direction);
#endif

// Fraction of the axial intensity in a unit direction from the light.
float litfog_cone(LitfogLight light, vec3 direction) {
#ifdef LITFOG_COOKIES
  if (light.axis_profile.w == LITFOG_PROFILE_COOKIE) return litfog_cookie(light, direction);
#endif
  return litfog_cone_at(light.axis_profile.w, dot(light.axis_profile.xyz, direction), light.cone.x, light.cone.y);
}

// Range attenuation up to the extent, 0 beyond it (Hales 2004, borders of the range map).
float litfog_range_attenuation(LitfogLight light, float range) {
  if (range > light.position_extent.w) return 0.0;
  return litfog_attenuation(range, light.attenuation.x, light.attenuation.y, light.attenuation.z);
}

// Light that arrives at the end of a ray from the light: colour * cone * range attenuation. There is no early exit,
// because a branch costs more than it saves on some drivers; callers skip lights that do not reach.
vec3 litfog_light_along(LitfogLight light, vec4 ray) {
  return light.color_intensity.rgb * (litfog_cone(light, ray.xyz) * litfog_range_attenuation(light, ray.w));
}

#endif
