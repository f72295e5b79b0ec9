// SPDX-License-Identifier: Apache-2.0
#include "render/light/light_selection.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

#include "render/light/light_finder.h"

namespace litfog::render {

LightSelection select_lights(const SceneLights& lights, std::span<const double> ranges, std::vector<std::int32_t> local,
                             const scene::Bounds& bounds) {
  constexpr double kFarthest = std::numeric_limits<double>::infinity();  // lit fog is seen at any range
  LightSelection selection{.surface = std::move(local), .is_fog_lit = false};
  for (std::size_t i = lights.local_count(); i < lights.size(); ++i) {
    const PlacedLight& light = lights.lights()[i];
    if (can_reach(light, ranges[i], bounds)) selection.surface.push_back(std::int32_t(i));
    selection.is_fog_lit = selection.is_fog_lit || can_reach(light, kFarthest, bounds);
  }
  return selection;
}

std::vector<std::int32_t> fog_lights(const SceneLights& lights, Skipping skipping) {
  std::vector<std::int32_t> shining;
  for (std::size_t i = lights.local_count(); i < lights.size(); ++i) {
    if (skipping == Skipping::off || lights.packed(i).kind.cone_scale_intensity.w > 0)
      shining.push_back(std::int32_t(i));
  }
  return shining;
}

std::vector<std::int32_t> grouped_by_maps(std::span<const std::int32_t> lights, std::span<const int> map_kinds) {
  std::vector<std::int32_t> grouped(lights.begin(), lights.end());
  if (!map_kinds.empty()) {
    std::ranges::stable_sort(grouped, {}, [&](std::int32_t i) { return map_kinds[std::size_t(i)]; });
  }
  return grouped;
}

std::vector<std::int32_t> with_fog_lights(std::span<const std::int32_t> lights,
                                          std::span<const std::int32_t> fog_lights, std::span<const int> map_kinds) {
  std::vector<std::int32_t> all(lights.begin(), lights.end());
  std::ranges::copy_if(fog_lights, std::back_inserter(all),
                       [&](std::int32_t light) { return std::ranges::find(lights, light) == lights.end(); });
  return grouped_by_maps(all, map_kinds);
}

std::size_t batch_length(std::span<const std::int32_t> lights, std::size_t most, std::span<const int> map_kinds) {
  const auto first = lights.first(std::min(lights.size(), most));
  if (map_kinds.empty()) return first.size();
  const auto is_of_another = [&](std::int32_t i) {
    return map_kinds[std::size_t(i)] != map_kinds[std::size_t(first.front())];
  };
  return std::size_t(std::ranges::find_if(first, is_of_another) - first.begin());
}

}  // namespace litfog::render
