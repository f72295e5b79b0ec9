// SPDX-License-Identifier: Apache-2.0
// One sample of each pixel of a geometry buffer's target, top row first.
uniform sampler2DMS target;
uniform sampler2DMS depths;
uniform bool ends_in_depth;  // the target's last component is the sample's depth
uniform int top_row;
uniform int sample_index;

out vec4 value;

void main() {
  ivec2 pixel = ivec2(int(gl_FragCoord.x), top_row - int(gl_FragCoord.y));
  value = texelFetch(target, pixel, sample_index);
  if (ends_in_depth) value.w = texelFetch(depths, pixel, sample_index).r;
}
