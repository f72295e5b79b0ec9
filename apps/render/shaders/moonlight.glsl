// SPDX-License-Identifier: Apache-2.0
// The directional light in fog that it lights (render::is_fog_moonlit). In other fog it lights surfaces alone, as in
// clear air.

#include "litfog/shaders/directional_airlight.glsl"

uniform bool is_fog_moonlit;
uniform float fog_top;  // metres

// Fraction of the directional light that passes through the fog down to a height.
float moon_fog_factor(float height) {
  return is_fog_moonlit ? litfog_directional_factor(height, moon_direction, fog_top) : 1.0;
}

// What the fog between the eye and a position scatters of the directional light.
vec3 moon_airlight(vec3 position, vec3 eye) {
  float range = distance(position, eye);
  if (!is_fog_moonlit || range == 0.0) return vec3(0.0);
  return moon_color * (litfog_airlight_unit() * litfog_directional_airlight(eye, (position - eye) / range, range,
                                                                            moon_direction, fog_top));
}
