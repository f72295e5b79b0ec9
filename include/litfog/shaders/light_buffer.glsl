// SPDX-License-Identifier: Apache-2.0
// litfog: any number of lights: the tables of litfog/fog_light_block.h in two textures or storage buffers.
//
// The textures are buffer textures of RGBA32F texels, one per vec4: two per kind, three per instance. Before the first
// include of litfog a program may define
// - LITFOG_LIGHT_TEXTURE: 2-D textures of any width, filled row by row; GLSL ES before 3.20 has no buffer textures and
//   uses these, unless it uses storage buffers;
// - LITFOG_LIGHT_STORAGE: storage buffers, std430, at LITFOG_KIND_BINDING (default 1) and LITFOG_INSTANCE_BINDING
//   (default 2); needs GLSL 4.30, ES 3.10 or Vulkan.
// In Vulkan the textures also have these bindings, and all are in LITFOG_SET (default 0).

#ifndef LITFOG_LIGHT_BUFFER_GLSL
#define LITFOG_LIGHT_BUFFER_GLSL

#include "litfog/shaders/light.glsl"

#if defined(GL_ES) && __VERSION__ < 320 && !defined(LITFOG_LIGHT_TEXTURE)
#define LITFOG_LIGHT_TEXTURE
#endif

#ifndef LITFOG_SET
#define LITFOG_SET 0
#endif
#ifndef LITFOG_KIND_BINDING
#define LITFOG_KIND_BINDING 1
#endif
#ifndef LITFOG_INSTANCE_BINDING
#define LITFOG_INSTANCE_BINDING 2
#endif

#ifdef LITFOG_LIGHT_STORAGE

#ifdef VULKAN
#define LITFOG_STORAGE_AT(slot) set = LITFOG_SET, binding = slot
#else
#define LITFOG_STORAGE_AT(slot) binding = slot
#endif
layout(LITFOG_STORAGE_AT(LITFOG_KIND_BINDING), std430) readonly buffer LitfogKindBuffer {
  LitfogKind litfog_kind_buffer[];
};
layout(LITFOG_STORAGE_AT(LITFOG_INSTANCE_BINDING), std430) readonly buffer LitfogInstanceBuffer {
  LitfogInstance litfog_instance_buffer[];
};

LitfogKind litfog_buffered_kind(int kind) { return litfog_kind_buffer[kind]; }
LitfogInstance litfog_buffered_instance(int light) { return litfog_instance_buffer[light]; }

#else

#ifdef LITFOG_LIGHT_TEXTURE
#define LITFOG_LIGHT_SAMPLER sampler2D
#else
#define LITFOG_LIGHT_SAMPLER samplerBuffer
#endif

#ifdef VULKAN
layout(set = LITFOG_SET, binding = LITFOG_KIND_BINDING)
#endif
uniform highp LITFOG_LIGHT_SAMPLER litfog_kind_buffer;
#ifdef VULKAN
layout(set = LITFOG_SET, binding = LITFOG_INSTANCE_BINDING)
#endif
uniform highp LITFOG_LIGHT_SAMPLER litfog_instance_buffer;

vec4 litfog_texel(highp LITFOG_LIGHT_SAMPLER table, int texel) {
#ifdef LITFOG_LIGHT_TEXTURE
  int width = textureSize(table, 0).x;
  return texelFetch(table, ivec2(texel % width, texel / width), 0);
#else
  return texelFetch(table, texel);
#endif
}

LitfogKind litfog_buffered_kind(int kind) {
  int texel = kind * 2;
  return LitfogKind(litfog_texel(litfog_kind_buffer, texel), litfog_texel(litfog_kind_buffer, texel + 1));
}
LitfogInstance litfog_buffered_instance(int light) {
  int texel = light * 3;
  return LitfogInstance(litfog_texel(litfog_instance_buffer, texel), litfog_texel(litfog_instance_buffer, texel + 1),
                        litfog_texel(litfog_instance_buffer, texel + 2));
}

#endif

LitfogLight litfog_buffered_light(int light) {
  LitfogInstance instance = litfog_buffered_instance(light);
  return litfog_light(instance, litfog_buffered_kind(int(instance.position_kind.w)));
}

// The light's position_extent alone, to test whether it reaches a point before the rest is fetched.
vec4 litfog_buffered_position_extent(int light) {
  vec4 position_kind = litfog_buffered_instance(light).position_kind;
  return vec4(position_kind.xyz, litfog_buffered_kind(int(position_kind.w)).attenuation_extent.w);
}

#endif
