// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <limits>
#include <optional>
#include <stdexcept>

#include "litfog/value_error.h"

namespace litfog {

/// Throws an error as the exception that the public calls promise.
inline void require(const std::optional<ValueError>& error) {
  if (error) throw std::invalid_argument(to_string(*error));
}

/// Finite and >= 0; false for NaN.
inline bool is_finite_and_not_negative(double x) { return x >= 0 && x <= std::numeric_limits<double>::max(); }

/// What is wrong with a colour whose components are called so, or nothing.
inline std::optional<ValueError> check_color(const glm::dvec3& color, const std::array<const char*, 3>& names) {
  for (int i = 0; i < 3; ++i) {
    if (!is_finite_and_not_negative(color[i])) {
      return ValueError{names[std::size_t(i)], color[i], "must be finite and >= 0"};
    }
  }
  return std::nullopt;
}

}  // namespace litfog
