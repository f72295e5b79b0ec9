// SPDX-License-Identifier: Apache-2.0
// Looks up the airlight of lights beyond their extents.

#include "far_airlight.glsl"

uniform sampler2D far_airlight;  // before each slab, and behind the last: as many pictures, the first at the bottom

// Along a ray through a place on the picture, in pixels, up to a range.
vec3 far_airlight_at(vec2 place, float range) {
  if (far_depth <= 0.0) return vec3(0.0);
  float part = sqrt(min(range / far_depth, 1.0)) * float(far_slabs);
  float slab = min(floor(part), float(far_slabs - 1));
  float begin = slab_begin(int(slab));
  float end = slab_begin(int(slab) + 1);
  vec2 size = vec2(textureSize(far_airlight, 0)) / vec2(1.0, float(far_slabs + 1));  // of one picture
  vec2 texel = min((place - 0.5) / float(far_step) + 0.5, size - 0.5);
  vec2 scale = 1.0 / vec2(size.x, size.y * float(far_slabs + 1));
  vec3 before = texture(far_airlight, vec2(texel.x, texel.y + slab * size.y) * scale).rgb;
  vec3 behind = texture(far_airlight, vec2(texel.x, texel.y + (slab + 1.0) * size.y) * scale).rgb;
  return mix(before, behind, clamp((range - begin) / (end - begin), 0.0, 1.0));
}
