// SPDX-License-Identifier: Apache-2.0
// Range attenuation from two 2-D maps: s and t give q, then q and r give the attenuation (Steven Hales 2004, "Realtime
// Pixel Lighting Using Fragment Programs", section "Embedding Range Attenuation in a Texture Map", the method for cards
// that are short of memory). With the cube map these take three of a card's four texture units, which leaves one
// texture for a face. This path draws the second texture, too.

#include "depth_test.glsl"
#include "path/lookup.glsl"

uniform sampler2D distance_map;
uniform sampler2D range_map;

float range_attenuation(vec3 str) {
  float q = texture(distance_map, map_coordinate(str.xy, textureSize(distance_map, 0).x)).r;
  return texture(range_map, map_coordinate(vec2(q, str.z), textureSize(range_map, 0).x)).r;
}
