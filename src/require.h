// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>
#include <stdexcept>

#include "litfog/value_error.h"

namespace litfog {

/// Turns a refusal into the exception that the public calls promise.
inline void require(const std::optional<ValueError>& refusal) {
  if (refusal) throw std::invalid_argument(to_string(*refusal));
}

/// Finite and >= 0; false for NaN.
inline bool is_finite_and_not_negative(double x) { return x >= 0 && x <= std::numeric_limits<double>::max(); }

}  // namespace litfog
