// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <span>
#include <vector>

#include "litfog/photometry/intensity_distribution.h"

namespace litfog {

/// Radians; keeps a direction at the last measured angle from rounding to beyond it.
inline constexpr double kAngleTolerance = 1e-9;

/// Finds the interval between measured angles that holds an angle, by buckets of equal width. Each bucket stores the
/// interval in which it begins, mostly the right one.
struct AngleIndex {
  AngleIndex() = default;
  /// angles  two or more, strictly increasing
  /// stride  distance between intensities of successive angles
  AngleIndex(std::span<const double> angles, std::size_t stride);

  bool is_outside(double angle) const { return !(angle >= first - kAngleTolerance && angle <= last + kAngleTolerance); }
  std::size_t bucket_of(double angle) const {
    return std::size_t(std::int64_t(std::min(std::max((angle - first) * scale, 0.0), last_bucket)));
  }
  /// The interval that holds an angle, or one next to it.
  std::size_t interval(double angle) const {
    std::size_t interval = intervals[bucket_of(angle)];
    while (angle >= low[interval + 1]) ++interval;
    return interval;
  }
  /// The fraction of an interval up to an angle in it.
  double fraction(std::size_t interval, double angle) const {
    return std::min(std::max((angle - low[interval]) * reciprocal[interval], 0.0), 1.0);
  }

  double first = 0, last = 0;  // angles
  double scale = 0;            // from angles to buckets
  double last_bucket = 0;
  std::size_t stride = 0;
  std::vector<std::uint32_t> intervals = {};  // by bucket
  std::vector<double> low = {};               // lower angle, by interval, then infinity
  std::vector<double> reciprocal = {};        // 1 / width, by interval
};

/// The number of measured parts in a whole turn of type C: 1, 2 or 4.
inline int turn_multiplicity(std::span<const double> turn) {
  const double span = turn.back() - turn.front();
  return span > 1.5 * std::numbers::pi ? 1 : span > 0.75 * std::numbers::pi ? 2 : 4;
}

/// Whether angles of type A or B are mirrored at 0.
inline bool is_mirrored(std::span<const double> angles) { return angles.front() == 0; }

/// The number of times that the measured part is repeated over the sphere.
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
