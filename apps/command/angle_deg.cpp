// SPDX-License-Identifier: Apache-2.0
#include "command/angle_deg.h"

#include <fmt/format.h>

#include "command/number.h"

namespace litfog::command {

double degrees(double radians) {
  const double quotient = radians / std::numbers::pi * 180;
  constexpr int kMostDigits = 17;
  for (int digits = 1; digits <= kMostDigits; ++digits) {
    const double rounded = *parse_number(fmt::format("{:.{}g}", quotient, digits));
    if (command::radians(rounded) == radians) return rounded;
  }
  return quotient;
}

}  // namespace litfog::command
