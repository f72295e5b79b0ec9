// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>

namespace litfog {

/// A number for a sentence in any locale, rounded to `digits` digits, or to an integer if that has more. No exponent
/// from 1e-4 to 1e15.
inline std::string shown_rounded(double number, int digits) {
  constexpr double kMinFixed = 1e-4, kMaxFixed = 1e15;
  constexpr int kMaxDigits = 9;
  if (number == 0) return "0";
  std::array<char, 32> text;
  const auto view = [&text](const char* end) { return std::string_view(text.data(), std::size_t(end - text.data())); };
  const double size = std::abs(number);
  if (std::isfinite(number)) {
    const int whole = int(std::floor(std::log10(size))) + 1;
    const auto rounded = view(std::to_chars(text.begin(), text.end(), number, std::chars_format::scientific,
                                            std::clamp(whole, digits, kMaxDigits) - 1)
                                  .ptr);
    std::from_chars(rounded.data(), rounded.data() + rounded.size(), number);
  }
  const bool is_fixed = size >= kMinFixed && size < kMaxFixed;
  const auto end = is_fixed ? std::to_chars(text.begin(), text.end(), number, std::chars_format::fixed)
                            : std::to_chars(text.begin(), text.end(), number);
  return std::string(view(end.ptr));
}

/// shown_rounded() with a sign; 0 is "+0".
inline std::string shown_change(double number, int digits) {
  return (number < 0 ? "" : "+") + shown_rounded(number, digits);
}

/// A number for a sentence. With at most 9 digits, as a person writes it, it is shown as written; a computed number
/// with more digits is rounded to six, or to an integer if that has more.
inline std::string shown_number(double number) {
  constexpr int kMaxWritten = 9, kComputed = 6;
  std::array<char, 32> text;
  const auto end = std::to_chars(text.begin(), text.end(), number, std::chars_format::scientific).ptr;
  const std::string_view written(text.data(), std::size_t(end - text.data()));
  const auto digits =
      std::ranges::count_if(written.substr(0, written.find('e')), [](char c) { return c >= '0' && c <= '9'; });
  return shown_rounded(number, digits > kMaxWritten ? kComputed : kMaxWritten);
}

}  // namespace litfog
