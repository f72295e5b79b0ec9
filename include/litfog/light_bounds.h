// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec3.hpp>
#include <limits>
#include <numbers>
#include <optional>

#include "litfog/light.h"
#include "litfog/value_error.h"

namespace litfog {

/// The part of space that a light can light: all points within a range of the light and within an angle of its axis.
/// World space, metres, radians.
struct LightBounds {
  glm::dvec3 position{0.0};                                ///< each coordinate at most kMaxPosition in magnitude
  glm::dvec3 direction{0.0, 0.0, -1.0};                    ///< its length is 1 within kDirectionTolerance
  double range = std::numeric_limits<double>::infinity();  ///< >= 0; 0 lights nothing, infinity has no end
  double half_angle = std::numbers::pi;                    ///< [0, pi]; pi is a sphere

  friend bool operator==(const LightBounds&, const LightBounds&) = default;
};

/// What is wrong with bounds, or nothing. For a wrong direction the value is its length.
std::optional<ValueError> find_error(const LightBounds& bounds);

/// The bounds of a light within a range, such as light_reach() gives (airlight.h).
///
/// light  must pass find_error(); not checked here
/// range  metres, >= 0
inline LightBounds bounds_of(const PlacedLight& light, double range) {
  return {light.position, light.direction, range, cutoff_angle(light.light.cone)};
}

/// Tolerance of the overlap tests: the largest gap at which separate bodies may count as touching, as a fraction of the
/// largest distance of their points from the eye (a view) or from the light (a box).
inline constexpr double kCullSlack = 1e-9;

/// Whether a light can light anything in a box. World space, metres.
///
/// An answer of false is always right. An answer of true may be wrong in two cases: within kCullSlack of touching; and
/// for a half angle over 90 degrees, if part of the box is in the light's dark cone and the rest beyond its range
/// (light_bounds_test.cpp).
///
/// low, high  corners; coordinates are finite, and low's are at most high's
/// throws     std::invalid_argument naming field, value and rule
bool can_light(const LightBounds& light, const glm::dvec3& low, const glm::dvec3& high);

}  // namespace litfog
