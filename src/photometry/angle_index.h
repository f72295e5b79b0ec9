// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "photometry/measured_angles.h"

namespace litfog {

/// Finds the interval between measured angles that holds an angle, by buckets of even width. Each bucket stores the
/// interval in which it begins, which mostly is the one.
struct AngleIndex {
  AngleIndex() = default;
  /// angles  two or more, strictly increasing
  /// stride  distance between intensities of successive angles
  AngleIndex(std::span<const double> angles, std::size_t stride);

  bool is_outside(double angle) const { return !(angle >= first - kAngleTolerance && angle <= last + kAngleTolerance); }
  std::size_t bucket_of(double angle) const {
    return std::size_t(std::int64_t(std::min(std::max((angle - first) * scale, 0.0), last_bucket)));
  }
  /// The interval that holds an angle, or is next to it.
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

}  // namespace litfog
