// SPDX-License-Identifier: Apache-2.0
// Looks up the airlight of lights beyond their extents.

#include "airlight/far_airlight.glsl"

uniform sampler2D far_airlight;  // one picture before each slab and one behind the last, from the bottom up

// Airlight up to a range along the ray through a position in the picture, in pixels, from the eye's height.
vec3 far_airlight_at(vec2 position, float range, float eye_height, float rise) {
  if (far_depth <= 0.0) return vec3(0.0);
  float part = slabs_before(range, eye_height, rise);
  float slab = min(floor(part), float(far_slabs - 1));
  vec2 size = vec2(textureSize(far_airlight, 0)) / vec2(1.0, float(far_slabs + 1));  // one picture's
  vec2 texel = min((position - 0.5) / float(far_step) + 0.5, size - 0.5);
  vec2 scale = 1.0 / vec2(size.x, size.y * float(far_slabs + 1));
  vec3 before = texture(far_airlight, vec2(texel.x, texel.y + slab * size.y) * scale).rgb;
  vec3 behind = texture(far_airlight, vec2(texel.x, texel.y + (slab + 1.0) * size.y) * scale).rgb;
  return mix(before, behind, part - slab);
}
