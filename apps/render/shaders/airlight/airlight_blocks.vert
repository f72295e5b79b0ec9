// SPDX-License-Identifier: Apache-2.0
// A point covers one of a target's blocks of texels.

#include "airlight_blocks.glsl"

uniform int block_columns;
uniform vec2 target_size;  // texels

void main() {
  vec2 block = vec2(ivec2(gl_VertexID % block_columns, gl_VertexID / block_columns) * block_stride);
  gl_Position = vec4((block + 0.5) * (2.0 * float(block_size) / target_size) - 1.0, 0.0, 1.0);
  gl_PointSize = float(block_size);
}
