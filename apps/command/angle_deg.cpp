// SPDX-License-Identifier: Apache-2.0
#include "command/angle_deg.h"

#include <fmt/format.h>

#include "command/number.h"

double degrees(double radians) {
  const double quotient = radians / std::numbers::pi * 180;
  constexpr int kMostDigits = 17;
  for (int digits = 1; digits <= kMostDigits; ++digits) {
    const double rounded = *parse_number(fmt::format("{:.{}g}", quotient, digits));
    if (::radians(rounded) == radians) return rounded;
  }
  return quotient;
}
