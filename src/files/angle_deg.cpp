// SPDX-License-Identifier: Apache-2.0
#include "files/angle_deg.h"

#include <array>
#include <charconv>

#include "text/shown_number.h"

namespace litfog::files {

double degrees(double radians) {
  const double quotient = radians / std::numbers::pi * 180;
  constexpr int kMaxDigits = 17;
  double rounded = 0;
  int digits = 1;
  do {
    std::array<char, 32> text;  // 17 digits, a sign, a point and an exponent
    char* const end =
        std::to_chars(text.data(), text.data() + text.size(), quotient, std::chars_format::scientific, digits - 1).ptr;
    std::from_chars(text.data(), end, rounded);
  } while (files::radians(rounded) != radians && ++digits <= kMaxDigits);
  return rounded;
}

std::string shown_degrees(double radians) { return shown_number(degrees(radians)); }

}  // namespace litfog::files
