// SPDX-License-Identifier: Apache-2.0
// The texels of a grid for which a coarser one is not good enough, packed: those of a block of 8 x 8 stand at its first
// places in Morton order. Scattered texels would leave most lanes of a processor idle.

uniform ivec2 block_stride;   // from one packed block to the next, in blocks
uniform sampler2D row_marks;  // a texel has 8 bits, of 8 texels in a row: 1 for one that is not filled

const int block_size = 8;

int row_marks_at(ivec2 block, int row) {
  return int(texelFetch(row_marks, ivec2(block.x, block.y * block_size + row), 0).r);
}

int count_bits(int byte) {
  byte -= (byte >> 1) & 0x55;
  byte = (byte & 0x33) + ((byte >> 2) & 0x33);
  return (byte + (byte >> 4)) & 0x0f;
}

// Bits 0, 2 and 4 of an index, moved together.
int even_bits(int index) { return (index & 1) | (index >> 1 & 2) | (index >> 2 & 4); }

ivec2 packed_place(int index) { return ivec2(even_bits(index), even_bits(index >> 1)); }

// Bits 0, 1 and 2 moved to 0, 2 and 4.
int spread_bits(int bits) { return (bits & 1) | (bits & 2) << 1 | (bits & 4) << 2; }

int packed_index(ivec2 place) { return spread_bits(place.x) | spread_bits(place.y) << 1; }
