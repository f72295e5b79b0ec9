// SPDX-License-Identifier: Apache-2.0
// Finds the grid texel for which a packed texel stands.

#include "airlight/airlight_blocks.glsl"

out vec2 place;

void main() {
  ivec2 here = ivec2(gl_FragCoord.xy);
  ivec2 packed_block = here / block_size;
  ivec2 block = packed_block / block_stride;
  int before = morton_index(here - packed_block * block_size);  // number of marked texels before this one in the block
  uint marks[mark_words] = marks_of(block);
  uint bits = 0u;  // the word that has the texel's bit
  int index = 0;
  int rest = before;
  for (int word = 0; word < mark_words; ++word) {
    if (before >= 0) {
      bits = marks[word];
      index = 32 * word;
      rest = before;
    }
    before -= count_bits(marks[word]);
  }
  if (before >= 0) discard;
  // Finds the bit that has `before` set bits below it, by bisection.
  for (int halving = 0; halving < 5; ++halving) {
    int half_size = 16 >> halving;
    int count = count_bits(bits & (1u << uint(half_size)) - 1u);
    if (rest >= count) {
      rest -= count;
      bits >>= uint(half_size);
      index += half_size;
    }
  }
  place = vec2(block * block_size + morton_position(index));
}
