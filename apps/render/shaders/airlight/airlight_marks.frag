// SPDX-License-Identifier: Apache-2.0
// Which texels of a grid are not filled, 8 in a texel: row_marks of airlight_blocks.glsl.

#include "airlight_blocks.glsl"

uniform sampler2D airlight;  // of the grid; alpha 1 where it is filled

out float marks;

void main() {
  ivec2 first = ivec2(gl_FragCoord.xy) * ivec2(block_size, 1);
  ivec2 size = textureSize(airlight, 0);
  marks = 0.0;
  for (int i = 0; i < block_size; ++i) {
    ivec2 place = first + ivec2(i, 0);
    if (all(lessThan(place, size)) && texelFetch(airlight, place, 0).a == 0.0) marks += float(1 << i);
  }
}
