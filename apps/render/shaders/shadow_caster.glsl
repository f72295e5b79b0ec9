// SPDX-License-Identifier: Apache-2.0
// Lamps that cast shadows, and their maps (render::ShadowMaps).

#include "shadow_map_place.glsl"

uniform sampler2DArrayShadow shadow_maps;  // distance from the lamp to the nearest surface, over the lamp's reach
uniform samplerBuffer shadow_casters;
uniform isamplerBuffer caster_of_light;  // -1: casts no shadows

struct ShadowCaster {
  vec3 position;
  mat3 frame_from_world;
  float half_size;  // of a map, a metre before the lamp; 0: its maps are a cube
  float reach;
  int first_layer;
};

ShadowCaster shadow_caster(int i) {
  vec4 position_layer = texelFetch(shadow_casters, 3 * i);
  vec4 axis_half_size = texelFetch(shadow_casters, 3 * i + 1);
  vec4 up_reach = texelFetch(shadow_casters, 3 * i + 2);
  vec3 axis = axis_half_size.xyz;
  vec3 up = up_reach.xyz;
  return ShadowCaster(position_layer.xyz, transpose(mat3(cross(axis, up), up, -axis)), axis_half_size.w, up_reach.w,
                      int(position_layer.w));
}
