// SPDX-License-Identifier: Apache-2.0
// The scene's lights, from the uniform block: first those that the eye's vehicle carries.

#include "litfog/shaders/light_block.glsl"

uniform int carried_count;

LitfogLight light_at(int i) { return litfog_block_light(i); }
LitfogLight carried_light(int i) { return light_at(i); }
// The page draws lamps by airlight as photometric() makes them, with Q = 1 / R^2. A law that is wider than a metre is of
// a lamp whose source radius is not known.
float source_radius_at(int point) {
  float quadratic = light_at(carried_count + point).attenuation.z;
  return quadratic > 1.0 ? inversesqrt(quadratic) : 0.0;
}
