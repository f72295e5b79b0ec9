// SPDX-License-Identifier: Apache-2.0
// The lights of plain in a uniform array (plain.glsl defines their number), first the local ones, and its fog.

#include "cookie.glsl"
#include "litfog/shaders/light.glsl"
#include "generated/plain.glsl"

uniform vec4 lights[5 * LIGHT_COUNT];
uniform float density;
uniform bool is_exp2;
uniform vec3 ambient_fog_color;

LitfogLight light_at(int i) {
  return LitfogLight(lights[5 * i], lights[5 * i + 1], lights[5 * i + 2], lights[5 * i + 3], lights[5 * i + 4]);
}

float fog_factor(float range) {
  float depth = density * range;
  return exp(is_exp2 ? -depth * depth : -depth);
}
