// SPDX-License-Identifier: Apache-2.0
// The lights of plain in a uniform array (plain.glsl defines their number), first the local ones, and its fog.

#include "cookie.glsl"
#include "litfog/shaders/light.glsl"
#include "plain.glsl"

uniform vec4 lights[5 * LIGHT_COUNT];
uniform float density;
uniform bool is_exp2;
uniform vec3 ambient_fog_color;

LitfogLight light_at(int i) {
  return LitfogLight(lights[5 * i], lights[5 * i + 1], lights[5 * i + 2], lights[5 * i + 3], lights[5 * i + 4]);
}

// Fraction of a light's colour in a unit direction from it.
float beam(LitfogLight light, vec3 direction) {
  float cosine = dot(direction, light.axis_profile.xyz);
  int profile = int(light.axis_profile.w);
  if (profile == 1) return cosine > light.cone.x ? pow(cosine, light.cone.y) : 0.0;
  if (profile == 2) return smoothstep(light.cone.x, light.cone.y, cosine);
#ifdef LITFOG_COOKIES
  if (profile == 3) return litfog_cookie(light, direction);
#endif
  return 1.0;
}

float fog_factor(float range) {
  float depth = density * range;
  return exp(is_exp2 ? -depth * depth : -depth);
}
