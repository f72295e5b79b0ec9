// SPDX-License-Identifier: Apache-2.0
// Packed texels back to their places in the grid.

#include "airlight_blocks.glsl"

uniform sampler2D packed_airlight;
uniform sampler2D packed_gain;

layout(location = 0) out vec4 airlight;
layout(location = 1) out vec4 gain;

void main() {
  ivec2 here = ivec2(gl_FragCoord.xy);
  ivec2 block = here / block_size;
  ivec2 within = here - block * block_size;
  int index = count_bits(row_marks_at(block, within.y) & ((1 << within.x) - 1));
  for (int row = 0; row < within.y; ++row) index += count_bits(row_marks_at(block, row));
  ivec2 place = block * block_stride * block_size + packed_place(index);
  airlight = texelFetch(packed_airlight, place, 0);
  gain = texelFetch(packed_gain, place, 0);
}
