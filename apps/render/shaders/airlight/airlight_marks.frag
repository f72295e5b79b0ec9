// SPDX-License-Identifier: Apache-2.0
// Which texels of a block of a grid are not filled: block_marks of airlight_blocks.glsl.

#include "airlight_blocks.glsl"

uniform sampler2DRect airlight;  // of the grid; alpha below 0 where it is not filled

out uvec2 marks;

void main() {
  ivec2 first = ivec2(gl_FragCoord.xy) * block_size;
  ivec2 size = textureSize(airlight);
  marks = uvec2(0u);
  for (int i = 0; i < block_size * block_size; ++i) {
    ivec2 place = first + ivec2(i % block_size, i / block_size);
    bool is_marked = all(lessThan(place, size)) && texel_at(airlight, place).a < 0.0;
    if (is_marked) marks[i / 32] |= 1u << uint(i % 32);
  }
}
