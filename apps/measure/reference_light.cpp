// SPDX-License-Identifier: Apache-2.0
#include "measure/reference_light.h"

#include "litfog/fog_light_block.h"
#include "scene/light_frame.h"

namespace litfog::measure {

double ReferenceLight::emitted(const glm::dvec3& direction) const {
  return cookie ? cookie_at(*cookie, cookie_from_world * direction) : cone_at(cone, glm::dot(axis, direction));
}

std::vector<ReferenceLight> reference_lights(const scene::Scene& scene, const Fog& fog) {
  std::vector<ReferenceLight> lights;
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    const PlacedLight& placed = scene.lights[i];
    const Light& light = placed.light;
    const auto use = scene.cookie_uses.find(i);
    const bool has_cookie = use != scene.cookie_uses.end();
    lights.push_back({.position = placed.position,
                      .axis = placed.direction,
                      .color = light.color,
                      .attenuation = light.attenuation,
                      .cone = light.cone,
                      .extent = compute_extent(light.attenuation, light.threshold),
                      .fog_intensity = placed.carried ? solve_fog_intensity(light, fog).intensity : 0,
                      .cookie = has_cookie ? &scene.cookies[use->second.cookie] : nullptr,
                      .cookie_from_world =
                          has_cookie ? scene::cookie_from_world(placed.direction, use->second.roll) : glm::dmat3(1.0)});
  }
  return lights;
}

}  // namespace litfog::measure
