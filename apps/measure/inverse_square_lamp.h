// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <limits>

#include "litfog/airlight.h"

namespace litfog {

inline constexpr double kQuadratic = 1e12;  // 1 / I; inverse-square beyond a micrometre

/// A point lamp, 1 / (Q r^2), at a range ahead of the eye: metres or, in fog of density 1, optical depths.
inline PlacedLight lamp_ahead(double range) {
  Light light;
  light.attenuation = {.constant = 0, .linear = 0, .quadratic = kQuadratic};
  light.threshold = 1e-17;
  return {.light = light, .position = {0, 0, -range}};
}

/// A ray at an angle to the direction to the lamp, radians.
inline EyeRay ray_beside(double angle, double length = std::numeric_limits<double>::infinity()) {
  return {.direction = {std::sin(angle), 0, -std::cos(angle)}, .length = length};
}

}  // namespace litfog
