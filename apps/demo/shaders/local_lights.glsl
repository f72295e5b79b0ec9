// SPDX-License-Identifier: Apache-2.0
// The scene's lights that the eye's vehicle does not carry: any number, in a buffer texture of FogLights, and which of
// them can reach the surface drawn.

#include "cookie.glsl"
#include "litfog/light.glsl"

uniform samplerBuffer local_lights;
uniform isamplerBuffer light_list;
uniform ivec2 light_list_range;  // first, count: the local lights that can reach this surface

vec4 local_light_position_extent(int light) { return texelFetch(local_lights, light * 5); }

FogLight local_light(int light) {
  int texel = light * 5;
  return FogLight(texelFetch(local_lights, texel), texelFetch(local_lights, texel + 1),
                  texelFetch(local_lights, texel + 2), texelFetch(local_lights, texel + 3),
                  texelFetch(local_lights, texel + 4));
}

int listed_light(int i) { return texelFetch(light_list, light_list_range.x + i).x; }

// The lights that can reach this surface in one row: those that the eye's vehicle carries, then the local ones.
int reaching_light_count() { return int(litfog_fog.z) + light_list_range.y; }
FogLight reaching_light(int i) {
  int carried = int(litfog_fog.z);
  if (i < carried) return litfog_lights[i];
  return local_light(listed_light(i - carried));
}
