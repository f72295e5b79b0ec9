// SPDX-License-Identifier: Apache-2.0
// The lights of a surface that has too many for uniforms: first those that the eye's vehicle carries, then the local
// lights in the surface's light list.

#include "light_batch.glsl"
#include "litfog/shaders/light_block.glsl"
#include "litfog/shaders/light_buffer.glsl"

uniform isamplerBuffer light_list;
uniform ivec2 light_list_range;  // first, count: of this surface

int listed_light_count() { return has_listed_lights ? int(litfog_fog.z) + light_list_range.y : 0; }
int local_number(int i) { return texelFetch(light_list, light_list_range.x + i - int(litfog_fog.z)).x; }
LitfogLight listed_light(int i) {
  if (i < int(litfog_fog.z)) return litfog_lights[i];
  return litfog_buffered_light(local_number(i));
}

// Whether a position is beyond a light's extent: for a local light, known before the rest of it is fetched.
bool is_out_of_reach(int i, vec3 position) {
  if (i < int(litfog_fog.z)) return false;
  vec4 position_extent = litfog_buffered_position_extent(local_number(i));
  return distance(position_extent.xyz, position) > position_extent.w;
}
