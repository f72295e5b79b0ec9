// SPDX-License-Identifier: Apache-2.0
// The texel of the grid for which a packed one stands.

#include "airlight_blocks.glsl"

out vec2 place;

void main() {
  ivec2 here = ivec2(gl_FragCoord.xy);
  ivec2 packed_block = here / block_size;
  ivec2 block = packed_block / block_stride;
  int before = morton_index(here - packed_block * block_size);  // marked texels of the block that come before
  uint marks[mark_words] = marks_of(block);
  uint bits = 0u;  // of the word that has it
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
  // The bit that has so many set bits below it, by halving what is left.
  for (int halving = 0; halving < 5; ++halving) {
    int half_size = 16 >> halving;
    int count = count_bits(bits & (1u << uint(half_size)) - 1u);
    if (rest >= count) {
      rest -= count;
      bits >>= uint(half_size);
      index += half_size;
    }
  }
  place = vec2(block * block_size + morton_place(index));
}
