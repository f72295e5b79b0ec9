// SPDX-License-Identifier: Apache-2.0
// The night sky behind the fog up to its top.

#define LITFOG_FOG_LIGHTS
#include "cookie.glsl"
#include "fog_top.glsl"
#include "light_list.glsl"
#include "litfog/shaders/fog.glsl"
#include "night_sky.glsl"

in vec3 seen_direction;

uniform vec3 eye;

out vec4 color;

vec3 litfog_lights_fog(vec3 position) {
  vec3 fog = vec3(0.0);
  for (int i = 0; i < carried_count; ++i) fog += litfog_light_fog(carried_light(i), position);
  return fog;
}

void main() {
  vec3 direction = normalize(seen_direction);
  color = vec4(litfog_apply_fog(night_sky(direction), eye + direction * fog_before_sky(direction), eye), 1.0);
}
