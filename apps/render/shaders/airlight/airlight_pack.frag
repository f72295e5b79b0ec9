// SPDX-License-Identifier: Apache-2.0
// The texel of the grid for which a packed one stands.

#include "airlight_blocks.glsl"

out vec2 place;

void main() {
  ivec2 here = ivec2(gl_FragCoord.xy);
  ivec2 packed_block = here / block_size;
  ivec2 block = packed_block / block_stride;
  int before = packed_index(here - packed_block * block_size);  // marked texels of the block that come before
  uvec2 marks = marks_of(block);
  int low = count_bits(marks.x);
  bool is_high = before >= low;
  if (is_high) before -= low;
  uint bits = is_high ? marks.y : marks.x;
  if (before >= count_bits(bits)) discard;
  // The bit that has so many set bits below it, by halving what is left.
  int index = is_high ? 32 : 0;
  for (int halving = 0; halving < 5; ++halving) {
    int half_size = 16 >> halving;
    int count = count_bits(bits & (1u << uint(half_size)) - 1u);
    if (before >= count) {
      before -= count;
      bits >>= uint(half_size);
      index += half_size;
    }
  }
  place = vec2(block * block_size + ivec2(index % block_size, index / block_size));
}
