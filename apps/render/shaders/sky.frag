// SPDX-License-Identifier: Apache-2.0
// The night sky behind the fog up to its top.

#define LITFOG_FOG_LIGHTS
#include "cookie.glsl"
#include "carried_fog.glsl"
#include "fog_top.glsl"
#include "litfog/shaders/fog.glsl"
#include "night_sky.glsl"

#include "moonlight.glsl"

in vec3 seen_direction;

uniform vec3 eye;

out vec4 color;

void main() {
  vec3 direction = normalize(seen_direction);
  float range = fog_before_sky(direction);
  color = vec4(litfog_apply_fog(night_sky(direction), eye + direction * range, eye) +
                   moon_airlight(eye + direction * moonlit_before_sky(range, direction, eye), eye),
               1.0);
}
