// SPDX-License-Identifier: Apache-2.0
#include "fog_top.glsl"
#include "night_sky.glsl"
#include "plain_lights.glsl"

in vec3 seen_direction;

uniform vec3 eye;

out vec4 color;

void main() {
  vec3 direction = normalize(seen_direction);
  float range = fog_before_sky(direction);
  vec3 position = eye + direction * range;
  vec3 fog = ambient_fog_color;
  for (int i = LOCAL_COUNT; i < LIGHT_COUNT; ++i) {
    LitfogLight light = light_at(i);
    float cone = litfog_cone(light, normalize(position - light.position_extent.xyz));
    fog += light.color_intensity.rgb * (cone * light.color_intensity.w);
  }
  color = vec4(mix(fog, night_sky(direction), fog_factor(range)), 1.0);
}
