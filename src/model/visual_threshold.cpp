// SPDX-License-Identifier: Apache-2.0
#include "litfog/visual_threshold.h"

#include <algorithm>
#include <cmath>

namespace litfog {

double illuminance_threshold(double background) {
  constexpr double kLeast = -5.7;  // where the parabola is lowest
  const double x = background > 0 ? std::max(std::log10(background), kLeast) : kLeast;
  return std::pow(10, (0.05 * x + 0.57) * x - 6.66);
}

}  // namespace litfog
