// SPDX-License-Identifier: Apache-2.0
// Texels by their position in a texture; beyond its edge, those of the edge.
//
// Textures of one level are rectangles and are not looked up by texelFetch(): for that, Mesa's llvmpipe computes the
// size of a level anew for each fragment, which takes twice as long.

vec4 texel_at(sampler2DRect texels, ivec2 place) { return texture(texels, vec2(place) + 0.5); }
uvec4 texel_at(usampler2DRect texels, ivec2 place) { return texture(texels, vec2(place) + 0.5); }

// Whether a grid's texel has its airlight (AirlightTarget::kNotFilled).
bool is_filled(vec4 airlight) { return airlight.a >= 0.0; }
