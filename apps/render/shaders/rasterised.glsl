// SPDX-License-Identifier: Apache-2.0
// A fragment of a surface as rasterised: its position and its textures.

#include "draw_constants.glsl"

in vec3 rasterised_position;
in vec2 uv;

uniform sampler2D albedo_map;  // rgb reflectance, a gloss
uniform sampler2D normal_map;

// The position, clamped to the surface's bounds: a partly covered pixel is shaded at its centre, which near the horizon
// may be many metres beyond the surface, within reach of other lights.
vec3 fragment_position() { return clamp(rasterised_position, bounds_low, bounds_high); }
vec3 drawn_back() { return fragment_position() - rasterised_position; }

vec4 base_texture() { return texture(albedo_map, uv); }

// The normal map's normal in tangent space. The map's alpha gives the level that means 0 (Material::normal): 128 at 0,
// 127.5 at 1.
vec3 mapped_normal() {
  vec4 texel = texture(normal_map, uv);
  return texel.xyz * 2.0 - (256.0 - texel.a) * (1.0 / 255.0);
}
