// SPDX-License-Identifier: Apache-2.0
// litfog: the few lights that can light a fragment, and those that can light the fog in front of it: the table of
// litfog/light_clusters.h. Its lights are those of light_buffer.glsl, or a host's own, which it then sums itself.
//
// The table is a buffer texture of R32UI texels, a 2-D texture or a storage buffer, like the tables of
// light_buffer.glsl, at LITFOG_CLUSTER_BINDING (default 4).

#ifndef LITFOG_LIGHT_CLUSTERS_GLSL
#define LITFOG_LIGHT_CLUSTERS_GLSL

#include "litfog/shaders/light_airlight.glsl"
#include "litfog/shaders/light_buffer.glsl"

#ifndef LITFOG_CLUSTER_BINDING
#define LITFOG_CLUSTER_BINDING 4
#endif

#ifdef LITFOG_LIGHT_STORAGE
layout(LITFOG_STORAGE_AT(LITFOG_CLUSTER_BINDING), std430) readonly buffer LitfogClusterBuffer {
  uint litfog_cluster_buffer[];
};

int litfog_cluster_word(int word) { return int(litfog_cluster_buffer[word]); }

#else

#ifdef LITFOG_LIGHT_TEXTURE
#define LITFOG_CLUSTER_SAMPLER usampler2D
#else
#define LITFOG_CLUSTER_SAMPLER usamplerBuffer
#endif

#ifdef VULKAN
layout(set = LITFOG_SET, binding = LITFOG_CLUSTER_BINDING)
#endif
uniform highp LITFOG_CLUSTER_SAMPLER litfog_cluster_buffer;

int litfog_cluster_word(int word) {
#ifdef LITFOG_LIGHT_TEXTURE
  int width = textureSize(litfog_cluster_buffer, 0).x;
  return int(texelFetch(litfog_cluster_buffer, ivec2(word % width, word / width), 0).x);
#else
  return int(texelFetch(litfog_cluster_buffer, word).x);
#endif
}

#endif

struct LitfogLightList {
  int first;  // word of the table
  int count;
};

// Word at which a point's cluster begins in the table.
//
// place  position in the picture, from 0 to 1, y up: gl_FragCoord.xy over the picture's size
// depth  metres along the view's forward direction: 1.0 / gl_FragCoord.w with the usual projections
int litfog_cluster_at(vec2 place, float depth) {
  ivec3 parts = ivec3(litfog_cluster_word(0), litfog_cluster_word(1), litfog_cluster_word(2));
  float slice = intBitsToFloat(litfog_cluster_word(3)) * log2(depth) + intBitsToFloat(litfog_cluster_word(4));
  // The slice is kept within int's range, because a look-up at infinity or at 0 has none.
  ivec3 part = ivec3(floor(vec3(place * vec2(parts.xy), clamp(slice, 0.0, 64.0))));
  part = clamp(part, ivec3(0), parts - 1);
  return 5 + 4 * ((part.z * parts.y + part.y) * parts.x + part.x);
}

// The lights that can light a point.
LitfogLightList litfog_lights_at(vec2 place, float depth) {
  int cluster = litfog_cluster_at(place, depth);
  return LitfogLightList(litfog_cluster_word(cluster), litfog_cluster_word(cluster + 1));
}

// The lights that can light anything between the eye and a point: those whose airlight it shows.
LitfogLightList litfog_lights_along(vec2 place, float depth) {
  int cluster = litfog_cluster_at(place, depth);
  return LitfogLightList(litfog_cluster_word(cluster + 2), litfog_cluster_word(cluster + 3));
}

// Index of a list's light number i, from 0 to count - 1.
int litfog_listed_light(LitfogLightList list, int i) { return litfog_cluster_word(list.first + i); }

// Light that a list's lights throw through the fog on a matt surface, to be multiplied with its colour: the sum of
// litfog_light_along() * litfog_lamp_factor() * cosine.
//
// normal  unit
vec3 litfog_listed_surface_light(LitfogLightList list, vec3 position, vec3 normal) {
  vec3 sum = vec3(0.0);
  for (int i = 0; i < list.count; ++i) {
    LitfogLight light = litfog_buffered_light(litfog_listed_light(list, i));
    vec4 ray = litfog_ray(light.position_extent.xyz, position);
    float facing = max(-dot(ray.xyz, normal), 0.0);
    sum += litfog_light_along(light, ray) * (litfog_lamp_factor(light, position.y, ray.w) * facing);
  }
  return sum;
}

// The sum of litfog_light_airlight() of a list's lights.
vec3 litfog_listed_airlight(LitfogLightList list, vec3 eye, vec3 direction, float range) {
  vec3 sum = vec3(0.0);
  for (int i = 0; i < list.count; ++i)
    sum += litfog_light_airlight(litfog_buffered_light(litfog_listed_light(list, i)), eye, direction, range);
  return sum;
}

#endif
