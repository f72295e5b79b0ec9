// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace litfog {

/// 1 - cos u, and its inverse, because the cosines of a narrow cone differ in their last digits only.
inline double versine(double angle) {
  const double sine = std::sin(angle / 2);
  return 2 * sine * sine;
}
inline double angle_of_versine(double versine) { return 2 * std::atan2(std::sqrt(versine), std::sqrt(2 - versine)); }

}  // namespace litfog
