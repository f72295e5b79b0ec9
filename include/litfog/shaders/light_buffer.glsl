// SPDX-License-Identifier: Apache-2.0
// litfog: any number of lights in a texture: five RGBA32F texels a light, the members of litfog::FogLight in order.
//
// The texture is a buffer texture. LITFOG_LIGHT_TEXTURE, defined before the first include of litfog, makes it a 2-D
// texture of any width, filled row by row; GLSL ES before 3.20 has no buffer textures and always takes the 2-D texture.
// In Vulkan it is at LITFOG_SET (default 0) and LITFOG_BUFFER_BINDING (default 1).

#ifndef LITFOG_LIGHT_BUFFER_GLSL
#define LITFOG_LIGHT_BUFFER_GLSL

#include "litfog/shaders/light.glsl"

#if defined(GL_ES) && __VERSION__ < 320 && !defined(LITFOG_LIGHT_TEXTURE)
#define LITFOG_LIGHT_TEXTURE
#endif

#ifdef VULKAN
#ifndef LITFOG_SET
#define LITFOG_SET 0
#endif
#ifndef LITFOG_BUFFER_BINDING
#define LITFOG_BUFFER_BINDING 1
#endif
layout(set = LITFOG_SET, binding = LITFOG_BUFFER_BINDING)
#endif
#ifdef LITFOG_LIGHT_TEXTURE
uniform highp sampler2D litfog_light_buffer;

vec4 litfog_light_texel(int texel) {
  int width = textureSize(litfog_light_buffer, 0).x;
  return texelFetch(litfog_light_buffer, ivec2(texel % width, texel / width), 0);
}
#else
uniform highp samplerBuffer litfog_light_buffer;

vec4 litfog_light_texel(int texel) { return texelFetch(litfog_light_buffer, texel); }
#endif

LitfogLight litfog_buffered_light(int light) {
  int texel = light * 5;
  return LitfogLight(litfog_light_texel(texel), litfog_light_texel(texel + 1), litfog_light_texel(texel + 2),
                     litfog_light_texel(texel + 3), litfog_light_texel(texel + 4));
}

// Its position_extent alone: asked of a light that may not reach before all of it is fetched.
vec4 litfog_buffered_position_extent(int light) { return litfog_light_texel(light * 5); }

#endif
