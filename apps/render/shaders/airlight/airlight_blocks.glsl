// SPDX-License-Identifier: Apache-2.0
// Packs the texels of a grid that the coarser grid cannot fill: those of a block of 16 x 16 texels are moved to its
// first positions in Morton order. Scattered texels would leave most lanes of a processor idle.

#include "airlight/texel.glsl"

uniform ivec2 block_stride;  // from one packed block to the next, in blocks
// Two texels a block, side by side, the first with the lower half: one bit for each of the block's texels, in Morton
// order, 1 where the texel is not filled.
uniform usampler2DRect block_marks;

const int block_size = 16;

int count_bits(uint bits) {
  bits -= bits >> 1 & 0x55555555u;
  bits = (bits & 0x33333333u) + (bits >> 2 & 0x33333333u);
  bits = bits + (bits >> 4) & 0x0f0f0f0fu;
  return int(bits * 0x01010101u >> 24);
}

const int mark_words = 8;  // 32 bits each

uint[mark_words] marks_of(ivec2 block) {
  uvec4 low = texel_at(block_marks, ivec2(2 * block.x, block.y));
  uvec4 high = texel_at(block_marks, ivec2(2 * block.x + 1, block.y));
  return uint[mark_words](low.x, low.y, low.z, low.w, high.x, high.y, high.z, high.w);
}

// Bits 0, 2, 4 and 6 of an index, moved together.
int even_bits(int index) { return (index & 1) | (index >> 1 & 2) | (index >> 2 & 4) | (index >> 3 & 8); }

// The position in a block of an index in Morton order.
ivec2 morton_position(int index) { return ivec2(even_bits(index), even_bits(index >> 1)); }

// Bits 0, 1, 2 and 3 moved to 0, 2, 4 and 6.
int spread_bits(int bits) { return (bits & 1) | (bits & 2) << 1 | (bits & 4) << 2 | (bits & 8) << 3; }

int morton_index(ivec2 place) { return spread_bits(place.x) | spread_bits(place.y) << 1; }
