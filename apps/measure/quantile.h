// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

namespace litfog::measure {

/// The quantile of values at a fraction, interpolated between neighbours: fraction 0.5 is the median.
///
/// values    not empty
/// fraction  [0, 1]
inline double quantile(std::vector<double> values, double fraction) {
  assert(!values.empty());
  std::ranges::sort(values);
  const double position = fraction * double(values.size() - 1);
  const auto below = std::size_t(position);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return std::lerp(values[below], values[above], position - double(below));
}

}  // namespace litfog::measure
