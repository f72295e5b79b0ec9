// SPDX-License-Identifier: Apache-2.0
#include "render/light/light_finder.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "litfog/light_bounds.h"

namespace litfog::render {
namespace {

constexpr std::size_t kGroupSize = 64;

glm::dvec3 centre_of(const scene::Bounds& box) { return (glm::dvec3(box.low) + glm::dvec3(box.high)) / 2.0; }
glm::dvec3 half_size_of(const scene::Bounds& box) { return (glm::dvec3(box.high) - glm::dvec3(box.low)) / 2.0; }

}  // namespace

bool can_reach(const PlacedLight& light, double extent, const scene::Bounds& box) {
  return can_light(bounds_of(light, extent), box.low, box.high);
}

LightFinder::LightFinder(std::span<const PlacedLight> lights, std::span<const double> extents)
    : lights_(lights), extents_(extents) {
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const Box reach{lights[i].position - extents[i], lights[i].position + extents[i]};
    if (i % kGroupSize == 0) groups_.push_back(reach);
    const LightBounds bounds = bounds_of(lights[i], extents[i]);
    sectors_.push_back({bounds.position, glm::normalize(bounds.direction), bounds.range, std::cos(bounds.half_angle),
                        std::sin(bounds.half_angle)});
    groups_.back() = {glm::min(groups_.back().low, reach.low), glm::max(groups_.back().high, reach.high)};
  }
}

// A box is lit if its centre is inside the sector. It is dark if all of it is beyond the range, or beyond the plane
// that touches the cone along the line nearest to the centre: a cone of at most 90 degrees is convex. The margins are
// larger than can_reach() may err, so that the answers agree.
bool LightFinder::reaches(std::size_t light, const scene::Bounds& box, const glm::dvec3& centre,
                          const glm::dvec3& half) const {
  constexpr double kMargin = 10 * kCullSlack;
  const Sector& sector = sectors_[light];
  const glm::dvec3 offset = centre - sector.apex;
  const glm::dvec3 farthest = glm::abs(offset) + half;
  const double margin = kMargin * (farthest.x + farthest.y + farthest.z);
  const double along = glm::dot(offset, sector.axis);
  const glm::dvec3 across = offset - along * sector.axis;
  const double width = glm::length(across);  // below the margin it is rounding, without a direction
  const double outside = width * sector.cos_half_angle - along * sector.sin_half_angle;  // metres from the cone's side
  const auto is_within = [](const glm::dvec3& vector, double range) {
    return range > 0 && glm::dot(vector, vector) < range * range;
  };
  if (outside < -margin && is_within(offset, sector.range - margin)) return true;
  if (!is_within(glm::max(glm::abs(offset) - half, 0.0), sector.range + margin)) return false;
  if (outside > margin && width > margin && sector.cos_half_angle >= 0) {
    const glm::dvec3 normal = across * (sector.cos_half_angle / width) - sector.axis * sector.sin_half_angle;
    if (outside - glm::dot(glm::abs(normal), half) > margin) return false;
  }
  return can_reach(lights_[light], extents_[light], box);
}

std::vector<std::int32_t> LightFinder::reaching(const scene::Bounds& box) const {
  const glm::dvec3 centre = centre_of(box);
  const glm::dvec3 half = half_size_of(box);
  std::vector<std::int32_t> found;
  for (std::size_t group = 0; group < groups_.size(); ++group) {
    const bool meets = glm::all(glm::lessThanEqual(groups_[group].low, glm::dvec3(box.high))) &&
                       glm::all(glm::lessThanEqual(glm::dvec3(box.low), groups_[group].high));
    if (!meets) continue;
    const std::size_t end = std::min((group + 1) * kGroupSize, lights_.size());
    for (std::size_t i = group * kGroupSize; i < end; ++i) {
      if (reaches(i, box, centre, half)) found.push_back(std::int32_t(i));
    }
  }
  return found;
}

std::vector<std::int32_t> LightFinder::reaching(const scene::Bounds& box,
                                                std::span<const std::int32_t> candidates) const {
  const glm::dvec3 centre = centre_of(box);
  const glm::dvec3 half = half_size_of(box);
  std::vector<std::int32_t> found;
  std::ranges::copy_if(candidates, std::back_inserter(found),
                       [&](std::int32_t i) { return reaches(std::size_t(i), box, centre, half); });
  return found;
}

}  // namespace litfog::render
