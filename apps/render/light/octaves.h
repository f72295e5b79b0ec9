// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace litfog::render {

/// Sums light by octaves of brightness, to leave out the dimmest octaves up to a budget.
class Octaves {
 public:
  void add(double light) { sums_[octave_of(light)] += light; }

  /// The largest limit, a power of 2, below which all light together is at most the budget.
  double least_kept(double budget) const {
    double sum = 0;
    std::size_t octave = 0;
    while (octave < sums_.size() && (sum += sums_[octave]) <= budget) ++octave;
    return std::ldexp(1.0, int(octave) + kFirst);
  }

 private:
  static constexpr int kFirst = -64;
  static std::size_t octave_of(double light) { return std::size_t(std::clamp(std::ilogb(light) - kFirst, 0, 95)); }

  std::array<double, 96> sums_{};
};

}  // namespace litfog::render
