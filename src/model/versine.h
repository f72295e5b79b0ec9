// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace litfog {

/// 1 - cos u, and its inverse, because the cosines of a narrow cone differ in their last digits only.
inline double versine(double angle) {
  const double sine = std::sin(angle / 2);
  return 2 * sine * sine;
}
/// sin x / x - cos x: how much the mean cosine from -x to x exceeds that at the ends. Below 0.1, where they cancel, by
/// the series x^2 / 3 - x^4 / 30 + x^6 / 840 - ...
inline double mean_cosine_excess(double x) {
  const double square = x * x;
  if (square > 0.01) return std::sin(x) / x - std::cos(x);
  return square / 3 * (1 - square / 10 * (1 - square / 28 * (1 - square / 54 * (1 - square / 88))));
}
inline double angle_of_versine(double versine) { return 2 * std::atan2(std::sqrt(versine), std::sqrt(2 - versine)); }

}  // namespace litfog
