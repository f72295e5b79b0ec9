// SPDX-License-Identifier: Apache-2.0
// Marks which texels of half a grid's block are not filled: block_marks of airlight_blocks.glsl.

#include "airlight/airlight_blocks.glsl"

uniform sampler2DRect airlight;  // the grid

out uvec4 marks;

void main() {
  ivec2 here = ivec2(gl_FragCoord.xy);
  ivec2 block = ivec2(here.x / 2, here.y);
  int first = here.x % 2 * 128;  // index of the half's first texel
  ivec2 size = textureSize(airlight);
  marks = uvec4(0u);
  for (int i = 0; i < 32; ++i) {
    for (int word = 0; word < 4; ++word) {
      ivec2 place = block * block_size + morton_position(first + 32 * word + i);
      bool is_marked = all(lessThan(place, size)) && !is_filled(texel_at(airlight, place));
      if (is_marked) marks[word] |= 1u << uint(i);
    }
  }
}
