// SPDX-License-Identifier: Apache-2.0
#include "render/light_selection.h"

#include <algorithm>
#include <iterator>
#include <limits>

#include "render/light_finder.h"

namespace litfog::render {

LightSelection select_lights(const SceneLights& lights, std::span<const std::int32_t> local,
                             const scene::Bounds& bounds, std::span<const int> map_kinds, Skipping skipping) {
  constexpr double kFarthest = std::numeric_limits<double>::infinity();  // fog is lit as far as it is seen
  const bool takes_all = skipping == Skipping::off;
  LightSelection selection{.surface = {local.begin(), local.end()}, .fog = {}};
  bool is_fog_lit = takes_all;
  for (std::size_t i = lights.local_count(); i < lights.size(); ++i) {
    const PlacedLight& light = lights.lights()[i];
    if (takes_all || can_reach(light, lights.extents()[i], bounds)) selection.surface.push_back(std::int32_t(i));
    if (takes_all || lights.packed(i).kind.cone_scale_intensity.w > 0) {
      selection.fog.push_back(std::int32_t(i));
      is_fog_lit = is_fog_lit || can_reach(light, kFarthest, bounds);
    }
  }
  if (!is_fog_lit) selection.fog.clear();
  if (!map_kinds.empty()) {
    std::ranges::stable_sort(selection.surface, {}, [&](std::int32_t i) { return map_kinds[std::size_t(i)]; });
  }
  return selection;
}

std::vector<std::int32_t> with_fog_lights(const LightSelection& selection, std::span<const int> map_kinds) {
  std::vector<std::int32_t> lights = selection.surface;
  std::ranges::copy_if(selection.fog, std::back_inserter(lights), [&](std::int32_t light) {
    return std::ranges::find(selection.surface, light) == selection.surface.end();
  });
  std::ranges::stable_sort(lights, {}, [&](std::int32_t i) { return map_kinds[std::size_t(i)]; });
  return lights;
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
