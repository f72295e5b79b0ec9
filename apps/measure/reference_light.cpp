// SPDX-License-Identifier: Apache-2.0
#include "measure/reference_light.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "litfog/fog_light_block.h"
#include "litfog/photometry/cookie_airlight.h"
#include "render/light/scene_lights.h"
#include "scene/light_frame.h"

namespace litfog::measure {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

double ReferenceLight::emitted(const glm::dvec3& direction) const {
  return cookie ? cookie_at(*cookie, cookie_from_world * direction)
                : cone_at(placed.light.cone, glm::dot(placed.direction, direction));
}

double ReferenceLight::airlight(const Atmosphere& atmosphere, const EyeRay& ray) const {
  PlacedLight seen = placed;
  seen.light.threshold = fog_threshold;
  return cookie ? picture_airlight(seen, *cookie, cookie_from_world, atmosphere, ray)
                : picture_airlight(seen, atmosphere, ray);
}

std::vector<ReferenceLight> reference_lights(const scene::Scene& scene, const Atmosphere& atmosphere,
                                             const render::RenderSettings& settings, double exposure) {
  const bool has_far_ends = render::lights_fog_beyond_end(settings);
  const Fog fog_at_eye = atmosphere.fog_at(scene.camera.position.y);
  std::vector<ReferenceLight> lights;
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    PlacedLight placed = scene::lit_light(scene, i);
    placed.light = render::drawn_light(placed.light, settings, exposure);
    const Light& light = placed.light;
    // Beyond a light's end a(r) is below the threshold, and the fog's weights along a ray add up to less than 1.
    const double each = kCutOff * std::exp2(-exposure) / double(scene.lights.size());
    const double brightest =
        airlight_unit(atmosphere) * render::largest_component(light.color) * largest_phase(atmosphere.phase);
    const double fog_threshold =
        has_far_ends && brightest > 0 ? std::min(light.threshold, each / brightest) : light.threshold;
    const double extent = compute_extent(light.attenuation, light.threshold);
    const bool has_intensity = placed.carried && settings.fog_lighting == render::FogLighting::peak;
    const auto use = scene.cookie_uses.find(i);
    const bool has_cookie = use != scene.cookie_uses.end();
    lights.push_back({.placed = placed,
                      .extent = extent > 0 && render::lights_surfaces_beyond_end(settings) ? kInfinity : extent,
                      .fog_threshold = fog_threshold,
                      .fog_extent = compute_extent(light.attenuation, fog_threshold),
                      .fog_intensity = has_intensity ? solve_fog_intensity(light, fog_at_eye).intensity : 0,
                      .cookie = has_cookie ? &scene.cookies[use->second.cookie] : nullptr,
                      .cookie_from_world =
                          has_cookie ? scene::cookie_from_world(placed.direction, use->second.roll) : glm::dmat3(1.0)});
  }
  return lights;
}

}  // namespace litfog::measure
