// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "photometry/measured_angles.h"

namespace litfog {

/// Measured angles, to find others among them: by buckets of even width, each of which has the interval in which it
/// begins. Mostly that is the interval.
struct AngleIndex {
  AngleIndex() = default;
  /// angles  two or more, strictly increasing
  /// stride  of intensities from one angle to the next
  AngleIndex(std::span<const double> angles, std::size_t stride);

  bool is_outside(double angle) const { return !(angle >= first - kAngleTolerance && angle <= last + kAngleTolerance); }
  std::size_t bucket_of(double angle) const {
    return std::size_t(std::int64_t(std::min(std::max((angle - first) * scale, 0.0), last_bucket)));
  }
  /// That which holds an angle, or is next to it.
  std::size_t interval(double angle) const {
    std::size_t interval = intervals[bucket_of(angle)];
    while (angle >= low[interval + 1]) ++interval;
    return interval;
  }
  /// Of an interval, at an angle in it.
  double fraction(std::size_t interval, double angle) const {
    return std::min(std::max((angle - low[interval]) * reciprocal[interval], 0.0), 1.0);
  }

  double first = 0, last = 0;  // of the angles
  double scale = 0;            // from angles to buckets
  double last_bucket = 0;
  std::size_t stride = 0;
  std::vector<std::uint32_t> intervals = {};  // by bucket
  std::vector<double> low = {};               // angle, by interval, and infinity
  std::vector<double> reciprocal = {};        // of the width
};

}  // namespace litfog
