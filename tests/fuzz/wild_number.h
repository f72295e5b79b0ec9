// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cmath>
#include <iterator>
#include <numbers>

#include "reference/double_limits.h"
#include "reference/random_light.h"

namespace litfog::test {

/// Draws numbers of all kinds, and often those at which something begins or ends: limits of the interface, right
/// angles, numbers drawn before, their floats and the doubles beside them.
class WildNumbers {
 public:
  explicit WildNumbers(Random& random) : random_(random) {}

  double draw() {
    const int way = random_.below(8);
    double number = random_.pick(kLimits);
    if (way == 0) number = std::bit_cast<double>(random_.bits());
    if (way == 1 || way == 2) number = random_.log_uniform(1e-6, 1e6);
    if (way == 3) number = last_;
    if (way == 4) number = double(random_.below(21) - 10);
    const int nudge = random_.below(16);
    if (nudge == 0) number = std::nextafter(number, kInfinity);
    if (nudge == 1) number = std::nextafter(number, -kInfinity);
    if (nudge == 2) number = double(float(std::isfinite(number) && std::abs(number) > 3e38 ? 3e38 : number));
    if (nudge == 3) number = -number;
    return last_ = number;
  }

 private:
  static constexpr double kPi = std::numbers::pi;
  static constexpr double kLimits[]{0,        1,        0.05,  0.5,        1e-30,     1e30, 1e-100,   1e100,
                                    1e-300,   kMax,     kNan,  kDenormMin, kInfinity, kPi,  kPi / 2,  kPi / 3,
                                    kPi / 4,  2 * kPi,  1e6,   3600,       1e9,       1e-6, 1e-12,    0.99,
                                    16777216, 16777215, 0.999, 10,         0x1p-20,   255,  1 / 255., 1e4};

  Random& random_;
  double last_ = 1;
};

}  // namespace litfog::test
