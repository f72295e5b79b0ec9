// SPDX-License-Identifier: Apache-2.0
// One sample of each pixel of a geometry buffer's target, top row first.
uniform sampler2DMS target;
uniform int top_row;
uniform int sample_index;

out vec4 value;

void main() {
  value = texelFetch(target, ivec2(int(gl_FragCoord.x), top_row - int(gl_FragCoord.y)), sample_index);
}
