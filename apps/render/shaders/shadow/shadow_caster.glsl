// SPDX-License-Identifier: Apache-2.0
// Lamps that cast shadows, then the maps of the directional light, and all maps (render::ShadowMaps).

#include "shadow/shadow_map_place.glsl"

uniform sampler2DArrayShadow shadow_maps;  // distance from the lamp to the nearest surface, over the lamp's reach
uniform samplerBuffer shadow_casters;
uniform isamplerBuffer caster_of_light;  // -1: casts no shadows

struct ShadowCaster {
  vec3 position;
  mat3 frame_from_world;
  bool is_cube;
  float half_size;  // half a map's side, a metre before the lamp; directional light: metres
  float reach;
  int first_layer;
};

ShadowCaster shadow_caster(int i) {
  vec4 position_layer = texelFetch(shadow_casters, 3 * i);
  vec4 axis_half_size = texelFetch(shadow_casters, 3 * i + 1);
  vec4 up_reach = texelFetch(shadow_casters, 3 * i + 2);
  vec3 axis = axis_half_size.xyz;
  vec3 up = up_reach.xyz;
  bool is_cube = axis_half_size.w == 0.0;
  return ShadowCaster(position_layer.xyz, transpose(mat3(cross(axis, up), up, -axis)), is_cube,
                      is_cube ? 1.0 : axis_half_size.w, up_reach.w, int(position_layer.w));
}

// The lamp's map that holds a direction in the lamp's frame.
int map_towards(ShadowCaster caster, vec3 direction) { return caster.is_cube ? map_of_direction(direction) : 0; }

// The size of a map's texel, in the unit of half_size.
float texel_size(ShadowCaster caster) { return 2.0 * caster.half_size / float(textureSize(shadow_maps, 0).x); }
