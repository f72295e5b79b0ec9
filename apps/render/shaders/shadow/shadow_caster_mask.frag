// SPDX-License-Identifier: Apache-2.0
// shadow_caster.frag for a material with a mask.

#define main cast_shadow
#include "shadow/shadow_caster.frag"
#undef main

uniform sampler2D albedo_map;
uniform float least_coverage;

in vec2 uv;
in float coverage;

void main() {
  cast_shadow();
  if (textureLod(albedo_map, uv, 0.0).a * coverage < least_coverage) discard;
}
