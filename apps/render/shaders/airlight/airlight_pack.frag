// SPDX-License-Identifier: Apache-2.0
// The texel of the grid for which a packed one stands.

#include "airlight_blocks.glsl"

out vec2 place;

void main() {
  ivec2 here = ivec2(gl_FragCoord.xy);
  ivec2 packed_block = here / block_size;
  ivec2 block = packed_block / block_stride;
  int left = packed_index(here - packed_block * block_size);  // texels of the block that come before
  int marks = 0;                                              // of the texel's row
  int row = 0;
  for (; row < block_size; ++row) {
    marks = row_marks_at(block, row);
    int count = count_bits(marks);
    if (left < count) break;
    left -= count;
  }
  if (row == block_size) discard;
  int column = 0;
  for (; left > 0 || (marks & 1) == 0; ++column) {
    left -= marks & 1;
    marks >>= 1;
  }
  place = vec2(block * block_size + ivec2(column, row));
}
