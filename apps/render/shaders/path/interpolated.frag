// SPDX-License-Identifier: Apache-2.0
// The interpolated normal, normalised, without a normal map (Jason Lacroix 2005, "Let There Be Light!: A Unified
// Lighting Technique for a New Generation of Games", listing 2.2); the lighting is that of all surfaces (listing 2.1).

#include "depth_test.glsl"
#include "world_normal.glsl"

vec3 interpolated_normal() { return normalize(normal); }

#define mapped_world_normal interpolated_normal
#include "path/unified.frag"
