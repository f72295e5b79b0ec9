// SPDX-License-Identifier: Apache-2.0
// A lamp's light on a surface of the Basic model. By airlight the fog between lamp and surface dims it.

#include "cookie.glsl"
#include "litfog/shaders/surface.glsl"
#include "fragment.glsl"

vec3 lit_by(LitfogSurface surface, LitfogLight light) {
  vec4 ray = litfog_ray(light.position_extent.xyz, surface.position);
  float through = lamp_factor(light, surface.position.y, ray.w);
  return litfog_reflect(surface, -ray.xyz, litfog_light_along(surface_light(light), ray) * through);
}
