// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>
#include <span>

namespace litfog {

/// Radians: a direction at the last measured angle must not round to beyond it.
inline constexpr double kAngleTolerance = 1e-9;

/// The number of measured parts in a whole turn of type C: 1, 2 or 4.
inline int turn_multiplicity(std::span<const double> turn) {
  const double span = turn.back() - turn.front();
  return span > 1.5 * std::numbers::pi ? 1 : span > 0.75 * std::numbers::pi ? 2 : 4;
}

/// Of types A and B.
inline bool is_mirrored(std::span<const double> angles) { return angles.front() == 0; }

}  // namespace litfog
