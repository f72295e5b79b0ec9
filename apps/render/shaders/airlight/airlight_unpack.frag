// SPDX-License-Identifier: Apache-2.0
// Packed texels back to their places in the grid.

#include "airlight_blocks.glsl"
#include "seen.glsl"

uniform sampler2DRect packed_airlight;
uniform sampler2DRect packed_gain;
uniform int pixel_step;  // pixels between texels

layout(location = 0) out vec4 airlight;
layout(location = 1) out vec4 gain;

void main() {
  ivec2 here = ivec2(gl_FragCoord.xy);
  ivec2 block = here / block_size;
  ivec2 within = here - block * block_size;
  uvec2 marks = marks_of(block);
  int bit = within.y * block_size + within.x;
  uint below = (1u << uint(bit % 32)) - 1u;
  int index = bit < 32 ? count_bits(marks.x & below) : count_bits(marks.x) + count_bits(marks.y & below);
  ivec2 place = block * block_stride * block_size + packed_place(index);
  float opacity = mean_of(seen_opacities(seen_at(here * pixel_step), 1.0));
  airlight = vec4(texel_at(packed_airlight, place).rgb, opacity);
  gain = texel_at(packed_gain, place);
}
