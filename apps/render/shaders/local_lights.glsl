// SPDX-License-Identifier: Apache-2.0
// The scene's lights that the eye's vehicle does not carry: any number, in a buffer texture of FogLights.

#include "cookie.glsl"
#include "litfog/light.glsl"

uniform samplerBuffer local_lights;

vec4 local_light_position_extent(int light) { return texelFetch(local_lights, light * 5); }

FogLight local_light(int light) {
  int texel = light * 5;
  return FogLight(texelFetch(local_lights, texel), texelFetch(local_lights, texel + 1),
                  texelFetch(local_lights, texel + 2), texelFetch(local_lights, texel + 3),
                  texelFetch(local_lights, texel + 4));
}
