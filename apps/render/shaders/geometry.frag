// SPDX-License-Identifier: Apache-2.0
// What a surface's fragment is shaded from, unchanged, for the shading in double on the CPU.

#include "world_normal.glsl"

uniform float material;  // its number

layout(location = 0) out vec4 position_material;
layout(location = 1) out vec4 mapped_normal_gloss;
layout(location = 2) out vec4 normal_unused;
layout(location = 3) out vec4 albedo_unused;

void main() {
  vec4 base = base_texture();
  position_material = vec4(fragment_position(), material);
  mapped_normal_gloss = vec4(mapped_world_normal(), base.a);
  normal_unused = vec4(normal, 0.0);
  albedo_unused = vec4(base.rgb, 0.0);
}
