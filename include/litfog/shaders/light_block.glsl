// SPDX-License-Identifier: Apache-2.0
// litfog: the fog and up to 128 lights in a uniform block; its C++ side is litfog/fog_light_block.h.
//
// A program for fog of one mode may define LITFOG_FOG_MODE, 0.0 or 1.0, before the first include of litfog; compilers then
// leave the other out.
//
// In Vulkan the block is at LITFOG_SET (default 0) and LITFOG_BLOCK_BINDING (default 0).

#ifndef LITFOG_LIGHT_BLOCK_GLSL
#define LITFOG_LIGHT_BLOCK_GLSL

#include "litfog/shaders/light.glsl"

const int LITFOG_MAX_LIGHTS = 128;

#ifdef VULKAN
#ifndef LITFOG_SET
#define LITFOG_SET 0
#endif
#ifndef LITFOG_BLOCK_BINDING
#define LITFOG_BLOCK_BINDING 0
#endif
layout(set = LITFOG_SET, binding = LITFOG_BLOCK_BINDING, std140) uniform LitfogLightBlock {
#else
layout(std140) uniform LitfogLightBlock {
#endif
  vec4 litfog_fog;  // x density, y mode: 0 exp, 1 exp2, z number of lights
  vec4 litfog_ambient_fog_color;
  LitfogLight litfog_lights[LITFOG_MAX_LIGHTS];
};

// 0 exp, 1 exp2.
#ifdef LITFOG_FOG_MODE
float litfog_fog_mode() { return LITFOG_FOG_MODE; }
#else
float litfog_fog_mode() { return litfog_fog.y; }
#endif

#endif
