// SPDX-License-Identifier: Apache-2.0
// The texels of a grid for which a coarser one is not good enough, packed: those of a block of 8 x 8 stand at its first
// places in Morton order. Scattered texels would leave most lanes of a processor idle.

#include "texel.glsl"

uniform ivec2 block_stride;  // from one packed block to the next, in blocks
// Of a block: a bit for each of its texels, row by row from the lowest bit of x on, and then of y. 1: not filled.
uniform usampler2DRect block_marks;

const int block_size = 8;

uvec2 marks_of(ivec2 block) { return texel_at(block_marks, block).xy; }

int count_bits(uint bits) {
  bits -= bits >> 1 & 0x55555555u;
  bits = (bits & 0x33333333u) + (bits >> 2 & 0x33333333u);
  bits = bits + (bits >> 4) & 0x0f0f0f0fu;
  return int(bits * 0x01010101u >> 24);
}

// Bits 0, 2 and 4 of an index, moved together.
int even_bits(int index) { return (index & 1) | (index >> 1 & 2) | (index >> 2 & 4); }

ivec2 packed_place(int index) { return ivec2(even_bits(index), even_bits(index >> 1)); }

// Bits 0, 1 and 2 moved to 0, 2 and 4.
int spread_bits(int bits) { return (bits & 1) | (bits & 2) << 1 | (bits & 4) << 2; }

int packed_index(ivec2 place) { return spread_bits(place.x) | spread_bits(place.y) << 1; }
