// SPDX-License-Identifier: Apache-2.0
// The airlight of lights beyond their extents before each slab: prefix sums, from the sums within groups of slabs.

#include "airlight/far_airlight.glsl"

uniform sampler2DArray far_slab_sums;
uniform int row_count;  // texel rows of one slab

layout(location = 0) out vec4 airlight;

void main() {
  ivec2 place = ivec2(gl_FragCoord.xy);
  int before = place.y / row_count;  // slabs
  ivec2 texel = ivec2(place.x, place.y % row_count);
  int groups = before / slabs_at_once;
  airlight = vec4(0.0);
  for (int i = 0; i < groups; ++i) {
    airlight += texelFetch(far_slab_sums, ivec3(texel.x, texel.y + i * row_count, slabs_at_once - 1), 0);
  }
  int rest = before - groups * slabs_at_once;
  if (rest > 0) airlight += texelFetch(far_slab_sums, ivec3(texel.x, texel.y + groups * row_count, rest - 1), 0);
}
