// SPDX-License-Identifier: Apache-2.0
// The ray through a pixel.

uniform vec2 pixel_size;  // a pixel's size in clip space: 2 over the picture's size
uniform mat4 direction_from_clip;

// Unit direction from the eye through the centre of a pixel, which may lie beyond the picture's edge.
vec3 pixel_direction(ivec2 pixel) {
  vec4 seen = direction_from_clip * vec4((vec2(pixel) + 0.5) * pixel_size - 1.0, 1.0, 1.0);
  return normalize(seen.xyz / seen.w);
}
