// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>

namespace litfog {

/// A number for a sentence. One of at most 9 digits, as a person writes it, is shown as written; one that was computed
/// has more, and is rounded to six, or to an integer where that has more. No exponent from 1e-4 to 1e15. In any locale.
inline std::string shown_number(double number) {
  constexpr int kMostWritten = 9, kComputed = 6;
  constexpr double kLeastFixed = 1e-4, kLargestFixed = 1e15;
  std::array<char, 32> text;
  const auto view = [&text](const char* end) { return std::string_view(text.data(), std::size_t(end - text.data())); };
  const auto written = view(std::to_chars(text.begin(), text.end(), number, std::chars_format::scientific).ptr);
  const std::string_view significand = written.substr(0, written.find('e'));
  if (std::isfinite(number) &&
      std::ranges::count_if(significand, [](char c) { return c >= '0' && c <= '9'; }) > kMostWritten) {
    const int whole = int(std::floor(std::log10(std::abs(number)))) + 1;
    const auto rounded = view(std::to_chars(text.begin(), text.end(), number, std::chars_format::scientific,
                                            std::clamp(whole, kComputed, kMostWritten) - 1)
                                  .ptr);
    std::from_chars(rounded.data(), rounded.data() + rounded.size(), number);
  }
  const double size = std::abs(number);
  const bool is_fixed = number == 0 || (size >= kLeastFixed && size < kLargestFixed);
  const auto end = is_fixed ? std::to_chars(text.begin(), text.end(), number, std::chars_format::fixed)
                            : std::to_chars(text.begin(), text.end(), number);
  return std::string(view(end.ptr));
}

}  // namespace litfog
