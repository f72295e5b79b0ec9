// SPDX-License-Identifier: Apache-2.0
#include "render/light_finder.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace litfog::render {
namespace {

constexpr std::size_t kGroupSize = 64;

}  // namespace

bool can_reach(const PlacedLight& light, double extent, const scene::Bounds& box) {
  const glm::dvec3 low = box.low;
  const glm::dvec3 high = box.high;
  const glm::dvec3 nearest = glm::clamp(light.position, low, high);
  if (glm::distance(nearest, light.position) > extent) return false;
  const glm::dvec3 center = (low + high) * 0.5;
  const double radius = glm::distance(high, center);
  const double range = glm::distance(center, light.position);
  if (range <= radius) return true;
  // The box's sphere spans asin(radius / range) about the direction of its centre.
  const double angle = std::acos(std::clamp(glm::dot(center - light.position, light.direction) / range, -1.0, 1.0));
  constexpr double kRounding = 1e-6;  // of acos near 0
  return angle - std::asin(radius / range) <= cutoff_angle(light.light.cone) + kRounding;
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
