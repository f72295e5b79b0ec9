// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>

#include "float_limit.h"
#include "litfog/light.h"
#include "litfog/value_error.h"
#include "litfog/visual_threshold.h"

namespace litfog {

/// Throws an error as the exception that the public calls promise.
inline void require(const std::optional<ValueError>& error) {
  if (error) throw std::invalid_argument(to_string(*error));
}

/// Throws for a wrong count. A ValueError's double cannot hold every count.
[[noreturn]] inline void fail_count(const char* field, std::size_t count, const char* rule) {
  throw std::invalid_argument(std::string(field) + " = " + std::to_string(count) + ": " + rule);
}

/// Finite and >= 0; false for NaN.
inline bool is_finite_and_not_negative(double x) { return x >= 0 && x <= std::numeric_limits<double>::max(); }

/// Throws for a time at which no flash can be asked for.
inline void require_time(double seconds) {
  if (!(seconds >= 0 && seconds <= kMaxFlashSeconds)) require(ValueError{"seconds", seconds, "must be in [0, 1e9]"});
}

/// Throws for a background's luminance that has no illuminance_threshold.
inline void require_background(double luminance) {
  if (!is_within(luminance, 0, kMaxBackground)) {
    require(ValueError{"background", luminance, "must be in [0, 1e12]"});
  }
}

/// What is wrong with a colour with components of these names, or nothing.
inline std::optional<ValueError> check_color(const glm::dvec3& color, const std::array<const char*, 3>& names) {
  for (int i = 0; i < 3; ++i) {
    if (!is_finite_and_not_negative(color[i])) {
      return ValueError{names[std::size_t(i)], color[i], "must be finite and >= 0"};
    }
  }
  return std::nullopt;
}

/// What is wrong with a position with coordinates of these names, or nothing.
inline std::optional<ValueError> find_position_error(const glm::dvec3& position,
                                                     const std::array<const char*, 3>& names) {
  for (int i = 0; i < 3; ++i) {
    if (!is_within(position[i], -kMaxPosition, kMaxPosition)) {
      return ValueError{names[std::size_t(i)], position[i], "must be at most 16777216 in magnitude"};
    }
  }
  return std::nullopt;
}

/// What is wrong with a direction, or nothing. The value is its length.
inline std::optional<ValueError> find_direction_error(const glm::dvec3& direction, const char* name) {
  const double length = glm::length(direction);
  if (!(std::abs(length - 1) <= kDirectionTolerance)) return ValueError{name, length, "length must be 1 within 1e-6"};
  return std::nullopt;
}

}  // namespace litfog
