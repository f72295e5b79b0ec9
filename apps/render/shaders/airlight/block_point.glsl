// SPDX-License-Identifier: Apache-2.0
// Draws a point over the used part of each block of a target's texels.

#include "airlight/airlight_blocks.glsl"

uniform bool is_packed;  // otherwise all of a block is used
uniform int block_columns;
uniform vec2 target_size;  // texels

// Texels a side of the smallest square that holds the packed texels; 0 if there are none.
int packed_size(ivec2 block) {
  uint marks[mark_words] = marks_of(block);
  int count = 0;
  for (int word = 0; word < mark_words; ++word) count += count_bits(marks[word]);
  return count == 0 ? 0 : count <= 16 ? 4 : count <= 64 ? 8 : block_size;
}

void draw_block() {
  ivec2 block = ivec2(gl_VertexID % block_columns, gl_VertexID / block_columns);
  int size = is_packed ? packed_size(block) : block_size;
  vec2 middle = vec2(block * block_stride * block_size) + 0.5 * float(size);
  gl_Position = vec4(middle * (2.0 / target_size) - 1.0, 0.0, 1.0);
  if (size == 0) gl_Position.z = 2.0;  // outside the picture
  gl_PointSize = float(size);
}
