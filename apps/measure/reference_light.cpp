// SPDX-License-Identifier: Apache-2.0
#include "measure/reference_light.h"

#include "litfog/fog_light_block.h"
#include "litfog/photometry/cookie_airlight.h"
#include "render/scene_lights.h"
#include "scene/light_frame.h"

namespace litfog::measure {

double ReferenceLight::emitted(const glm::dvec3& direction) const {
  return cookie ? cookie_at(*cookie, cookie_from_world * direction)
                : cone_at(placed.light.cone, glm::dot(placed.direction, direction));
}

double ReferenceLight::airlight(const Fog& scene_fog, const EyeRay& ray, const Scattering& scattering) const {
  return cookie ? reference_airlight(placed, *cookie, cookie_from_world, scene_fog, ray, scattering)
                : reference_airlight(placed, scene_fog, ray, scattering);
}

std::vector<ReferenceLight> reference_lights(const scene::Scene& scene, const Fog& fog,
                                             const render::RenderSettings& settings, double exposure) {
  std::vector<ReferenceLight> lights;
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    PlacedLight placed = scene.lights[i];
    placed.light.threshold = render::threshold_of(placed.light, settings, exposure);
    placed.light.cone = render::drawn_cone(placed.light.cone, settings);
    const Light& light = placed.light;
    const bool has_intensity = placed.carried && settings.fog_lighting == render::FogLighting::peak;
    const auto use = scene.cookie_uses.find(i);
    const bool has_cookie = use != scene.cookie_uses.end();
    lights.push_back({.placed = placed,
                      .extent = compute_extent(light.attenuation, light.threshold),
                      .fog = scaled(fog, light.density_scale),
                      .fog_intensity = has_intensity ? solve_fog_intensity(light, fog).intensity : 0,
                      .cookie = has_cookie ? &scene.cookies[use->second.cookie] : nullptr,
                      .cookie_from_world =
                          has_cookie ? scene::cookie_from_world(placed.direction, use->second.roll) : glm::dmat3(1.0)});
  }
  return lights;
}

}  // namespace litfog::measure
