// SPDX-License-Identifier: Apache-2.0
// The directional light in fog that it lights (render::is_fog_moonlit). In other fog it lights only surfaces, as in
// clear air.

#include "litfog/shaders/directional_airlight.glsl"

uniform bool is_fog_moonlit;
uniform float light_top;  // metres: Atmosphere::light_top()

// Fraction of the directional light that passes through the fog down to a height.
float moon_fog_factor(float height) {
  return is_fog_moonlit ? litfog_directional_factor(height, moon_direction, light_top) : 1.0;
}

// The directional light's airlight between the eye and a position.
vec3 moon_airlight(vec3 position, vec3 eye) {
  float range = distance(position, eye);
  if (!is_fog_moonlit || range == 0.0) return vec3(0.0);
  return moon_color * (litfog_airlight_unit() * litfog_directional_airlight(eye, (position - eye) / range, range,
                                                                            moon_direction, light_top));
}

// The length of a ray to the sky on which the moon lights the fog: up to where its light enters.
//
// range  the ray's length in the fog, metres
float moonlit_before_sky(float range, vec3 direction, vec3 eye) {
  return direction.y > 0.0 ? min(range, max(light_top - eye.y, 0.0) / direction.y) : range;
}
