// SPDX-License-Identifier: Apache-2.0
#include "render/light/light_finder.h"

#include <algorithm>
#include <iterator>

#include "litfog/light_bounds.h"

namespace litfog::render {
namespace {

constexpr std::size_t kGroupSize = 64;

}  // namespace

bool can_reach(const PlacedLight& light, double extent, const scene::Bounds& box) {
  return can_light(bounds_of(light, extent), box.low, box.high);
}

LightFinder::LightFinder(std::span<const PlacedLight> lights, std::span<const double> extents)
    : lights_(lights), extents_(extents) {
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const Box reach{lights[i].position - extents[i], lights[i].position + extents[i]};
    if (i % kGroupSize == 0) groups_.push_back(reach);
    groups_.back() = {glm::min(groups_.back().low, reach.low), glm::max(groups_.back().high, reach.high)};
  }
}

std::vector<std::int32_t> LightFinder::reaching(const scene::Bounds& box) const {
  std::vector<std::int32_t> found;
  for (std::size_t group = 0; group < groups_.size(); ++group) {
    const bool meets = glm::all(glm::lessThanEqual(groups_[group].low, glm::dvec3(box.high))) &&
                       glm::all(glm::lessThanEqual(glm::dvec3(box.low), groups_[group].high));
    if (!meets) continue;
    const std::size_t end = std::min((group + 1) * kGroupSize, lights_.size());
    for (std::size_t i = group * kGroupSize; i < end; ++i) {
      if (can_reach(lights_[i], extents_[i], box)) found.push_back(std::int32_t(i));
    }
  }
  return found;
}

std::vector<std::int32_t> LightFinder::reaching(const scene::Bounds& box,
                                                std::span<const std::int32_t> candidates) const {
  std::vector<std::int32_t> found;
  std::ranges::copy_if(candidates, std::back_inserter(found), [&](std::int32_t i) {
    return can_reach(lights_[std::size_t(i)], extents_[std::size_t(i)], box);
  });
  return found;
}

}  // namespace litfog::render
