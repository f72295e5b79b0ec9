// SPDX-License-Identifier: Apache-2.0
// Normal maps in object space: "also possible and ... generally used to light dynamic objects" (Jason Lacroix 2005,
// "Let There Be Light!: A Unified Lighting Technique for a New Generation of Games", section "Per-pixel normal map
// based lighting"; he prints no line of it). The map's normal turns with its model. No tangent space is interpolated
// between vertices, so there is no seam where vertices share a normal but not a tangent (his note on listing 2.3). But
// each model needs a map of its own: it cannot tile, nor be shared by surfaces that face different ways, like the
// catalogue's. The lighting is that of unified.frag.

#include "depth_test.glsl"
#include "world_normal.glsl"

uniform mat4 world_from_model;

vec3 object_space_normal() { return normalize(mat3(world_from_model) * mapped_normal()); }

#define mapped_world_normal object_space_normal
#include "path/unified.frag"
