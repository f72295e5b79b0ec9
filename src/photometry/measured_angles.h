// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <numbers>
#include <numeric>
#include <span>

#include "litfog/photometry/intensity_distribution.h"

namespace litfog {

/// Radians, so that a direction at the last measured angle does not round to beyond it.
inline constexpr double kAngleTolerance = 1e-9;

/// The number of measured parts in a whole turn of type C: 1, 2 or 4.
inline int turn_multiplicity(std::span<const double> turn) {
  const double span = turn.back() - turn.front();
  return span > 1.5 * std::numbers::pi ? 1 : span > 0.75 * std::numbers::pi ? 2 : 4;
}

/// Whether angles of type A or B are mirrored at 0.
inline bool is_mirrored(std::span<const double> angles) { return angles.front() == 0; }

/// How many times the measured part is repeated over the sphere.
inline int measured_parts(const IntensityDistribution& distribution) {
  const auto& [type, horizontal, vertical, intensity] = distribution;
  if (type == PhotometryType::c) return horizontal.size() == 1 ? 1 : turn_multiplicity(horizontal);
  return (is_mirrored(horizontal) ? 2 : 1) * (is_mirrored(vertical) ? 2 : 1);
}

/// The mean over a turn of type C of values that are linear between the planes.
template <typename InPlane>
double mean_over_turn(std::span<const double> turn, const InPlane& in_plane) {
  if (turn.size() == 1) return in_plane(std::size_t(0));
  double sum = 0;
  for (std::size_t i = 1; i < turn.size(); ++i) {
    sum += (turn[i] - turn[i - 1]) * std::midpoint(in_plane(i - 1), in_plane(i));
  }
  return sum / (turn.back() - turn.front());
}

}  // namespace litfog
