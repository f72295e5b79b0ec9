// SPDX-License-Identifier: Apache-2.0
#include "command/number.h"

#include <charconv>
#include <cmath>

namespace litfog::command {

namespace {

template <typename Number>
std::optional<Number> parse(std::string_view text) {
  Number number;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || stop != end) return std::nullopt;
  return number;
}

}  // namespace

std::optional<double> parse_number(std::string_view text) {
  const auto number = parse<double>(text);
  return number && !std::isnan(*number) ? number : std::nullopt;
}

std::optional<int> parse_integer(std::string_view text) { return parse<int>(text); }

}  // namespace litfog::command
