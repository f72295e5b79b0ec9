// SPDX-License-Identifier: Apache-2.0
// The scene's lights, from the uniform block: first those that the eye's vehicle carries.

#include "litfog/shaders/light_block.glsl"

uniform int carried_count;

LitfogLight light_at(int i) { return litfog_block_light(i); }
LitfogLight carried_light(int i) { return light_at(i); }
// The page's lamps have source radii, and are drawn by airlight as photometric() makes them.
float source_radius_at(int point) { return inversesqrt(light_at(carried_count + point).attenuation.z); }
