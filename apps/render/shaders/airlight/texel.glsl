// SPDX-License-Identifier: Apache-2.0
// Reads texels by their position in a texture, clamped to its edge.
//
// Textures of one level are rectangles and not read by texelFetch(), for which Mesa's llvmpipe computes the size of a
// level anew for each fragment, which takes twice as long.

vec4 texel_at(sampler2DRect texels, ivec2 place) { return texture(texels, vec2(place) + 0.5); }
uvec4 texel_at(usampler2DRect texels, ivec2 place) { return texture(texels, vec2(place) + 0.5); }

// Whether a grid's texel has its airlight (AirlightTarget::kNotFilled).
bool is_filled(vec4 airlight) { return airlight.a >= 0.0; }
