// SPDX-License-Identifier: Apache-2.0
#include "render/shadow/shadow_caster.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "litfog/attenuation.h"
#include "litfog/cone.h"
#include "scene/light_frame.h"

namespace litfog::render {
namespace {

double brightness_from(const glm::dvec3& eye, const PlacedLight& placed) {
  return largest_component(placed.light.color) *
         attenuation_at(placed.light.attenuation, glm::distance(eye, placed.position));
}

}  // namespace

LightBounds bounds_of_map(const ShadowCaster& caster, int map) {
  constexpr double kAxes[6][3] = {{0, 0, -1}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}};
  const glm::dvec3 axis(kAxes[map][0], kAxes[map][1], kAxes[map][2]);
  return {.position = caster.position,
          .direction = glm::normalize(glm::transpose(caster.frame_from_world) * axis),
          .range = caster.reach,
          .half_angle = std::atan(std::numbers::sqrt2 * caster.half_size)};
}

std::vector<ShadowCaster> choose_shadow_casters(const SceneLights& lights, const scene::Bounds& bounds,
                                                const glm::dvec3& eye, std::size_t most, int map_size) {
  std::vector<std::pair<double, std::int32_t>> ranked;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const double brightness = brightness_from(eye, lights.lights()[i]);
    if (brightness > 0) ranked.emplace_back(-brightness, std::int32_t(i));
  }
  const auto is_local = [&](const auto& rank) { return std::size_t(rank.second) < lights.local_count(); };
  std::ranges::sort(ranked, {}, [&](const auto& rank) { return std::pair(is_local(rank), rank); });
  ranked.resize(std::min(ranked.size(), most));

  std::vector<ShadowCaster> casters;
  for (const auto& [rank, light] : ranked) {
    const PlacedLight& placed = lights.lights()[std::size_t(light)];
    const double half_angle = cutoff_angle(placed.light.cone);
    const bool is_cube = half_angle > kWidestShadowMap;
    // A map's corner is atan(sqrt(2)) from its centre.
    const bool is_lit_behind = half_angle > std::numbers::pi - std::atan(std::numbers::sqrt2);
    const double farthest = farthest_distance(placed.position, bounds);
    const double margin = 1 + 4.0 / map_size;  // the taps around a texel at the beam's edge
    casters.push_back(
        {.light = light,
         .scene_light = lights.scene_light(std::size_t(light)),
         .position = placed.position,
         .frame_from_world = scene::basis_from_world(placed.direction),
         .is_cube = is_cube,
         .map_count = !is_cube        ? 1
                      : is_lit_behind ? 6
                                      : 5,
         .half_size = is_cube ? 1 : margin * std::tan(half_angle),
         .reach = std::max(2 * kLampRadius, lights.light_surfaces_beyond_end()
                                                ? farthest
                                                : std::min(lights.extents()[std::size_t(light)], farthest))});
  }
  return casters;
}

}  // namespace litfog::render
