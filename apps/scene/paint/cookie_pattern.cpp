// SPDX-License-Identifier: Apache-2.0
#include "scene/paint/cookie_pattern.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/glm.hpp>
#include <numbers>

#include "litfog/formulas.h"

namespace litfog::scene {
namespace {

constexpr int kPatternSize = 256;  // a texel is a third of a degree

/// Spots in rings around the axis, as the mirrors of a ball lie.
double disco(const glm::dvec3& direction) {
  constexpr int kRings = 15;
  constexpr double kRing = std::numbers::pi / kRings;
  const double from_axis = std::acos(std::clamp(-direction.z, -1.0, 1.0));
  const double ring = (std::min(std::floor(from_axis / kRing), kRings - 1.0) + 0.5) * kRing;
  const double spots = std::max(1.0, std::round(2 * std::numbers::pi * std::sin(ring) / kRing));
  const double turn = 2 * std::numbers::pi / spots;
  const double spot = std::round(std::atan2(direction.y, direction.x) / turn) * turn;
  const glm::dvec3 middle(std::sin(ring) * std::cos(spot), std::sin(ring) * std::sin(spot), -std::cos(ring));
  return formulas::smoothstep_cone(glm::dot(direction, middle), std::cos(0.26 * kRing), std::cos(0.36 * kRing));
}

/// Two beams to the sides.
double beacon(const glm::dvec3& direction) {
  return formulas::smoothstep_cone(std::abs(direction.x), std::cos(glm::radians(8.0)), std::cos(glm::radians(24.0)));
}

}  // namespace

Cookie paint_cookie(std::string_view pattern) {
  assert(std::ranges::find(kCookiePatterns, pattern) != std::end(kCookiePatterns));
  const auto paint = pattern == "disco" ? disco : beacon;
  return make_cookie(kPatternSize, [paint](const glm::dvec3& direction) { return paint(glm::normalize(direction)); });
}

}  // namespace litfog::scene
