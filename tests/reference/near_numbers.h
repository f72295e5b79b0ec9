// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace litfog::test {

/// Draws a number at which something begins or ends, as it is, as a float rounds it, or up to 2 ulp beside that.
inline rc::Gen<double> near_one_of(std::vector<double> numbers) {
  return rc::gen::apply(
      [](double number, bool is_float, int steps) {
        if (is_float) number = double(float(number));
        const double towards =
            steps < 0 ? -std::numeric_limits<double>::infinity() : std::numeric_limits<double>::max();
        for (int step = 0; step < std::abs(steps); ++step) number = std::nextafter(number, towards);
        return number;
      },
      rc::gen::elementOf(std::move(numbers)), rc::gen::arbitrary<bool>(), rc::gen::inRange(-2, 3));
}

}  // namespace litfog::test
