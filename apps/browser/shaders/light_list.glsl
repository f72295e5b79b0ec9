// SPDX-License-Identifier: Apache-2.0
// The scene's lights, from the uniform block: first those that the eye's vehicle carries.

#include "litfog/shaders/light_block.glsl"

uniform int carried_count;

LitfogLight light_at(int i) { return litfog_block_light(i); }
LitfogLight carried_light(int i) { return light_at(i); }
