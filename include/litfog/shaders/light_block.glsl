// SPDX-License-Identifier: Apache-2.0
// litfog: the fog and up to 200 lights in a uniform block; its C++ side is litfog/fog_light_block.h.
//
// In Vulkan the block is at LITFOG_SET (default 0) and LITFOG_BLOCK_BINDING (default 0).

#ifndef LITFOG_LIGHT_BLOCK_GLSL
#define LITFOG_LIGHT_BLOCK_GLSL

#include "litfog/shaders/light.glsl"
#include "litfog/shaders/phase.glsl"

const int LITFOG_MAX_LIGHTS = 200;
const int LITFOG_MAX_DENSITY_KNOTS = 8;

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
  vec4 litfog_fog;  // x density, y mode for litfog_is_exp(), z number of lights, w albedo
  vec4 litfog_ambient_fog_color;  // w number of knots
  vec4 litfog_phase_lobes[2];  // LitfogPhaseLobe
  vec4 litfog_density_knots[LITFOG_MAX_DENSITY_KNOTS];  // x height, y density
  LitfogKind litfog_kinds[LITFOG_MAX_LIGHTS];
  LitfogInstance litfog_instances[LITFOG_MAX_LIGHTS];
};

LitfogPhase litfog_fog_phase() {
  vec4 first = litfog_phase_lobes[0];
  vec4 second = litfog_phase_lobes[1];
  return LitfogPhase(LitfogPhaseLobe(first.x, first.y, first.z, first.w),
                     LitfogPhaseLobe(second.x, second.y, second.z, second.w));
}

LitfogLight litfog_block_light(int light) {
  LitfogInstance instance = litfog_instances[light];
  return litfog_light(instance, litfog_kinds[int(instance.position_kind.w)]);
}

#endif
