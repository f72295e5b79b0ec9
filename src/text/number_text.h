// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

namespace litfog {

/// The shortest text that reads back as the same number, in any locale: "0.1", "1e-30", "inf", "nan".
inline std::string number_text(double number) {
  std::array<char, 32> text;  // 24 characters at most
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), number).ptr};
}

/// Parses a whole text as a number, in any locale: "1", "-2.5e3", ".5", "inf", "nan". Nothing for an empty text, white
/// space, a leading +, hexadecimal, trailing text, or a number beyond the type.
template <typename Number = double>
std::optional<Number> whole_number(std::string_view text) {
  Number number{};
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && stop == text.data() + text.size() ? std::optional(number) : std::nullopt;
}
template <typename Number = double>
std::optional<Number> finite_number(std::string_view text) {
  const auto number = whole_number<Number>(text);
  return number && std::isfinite(*number) ? number : std::nullopt;
}

}  // namespace litfog
