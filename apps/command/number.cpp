// SPDX-License-Identifier: Apache-2.0
#include "command/number.h"

#include <algorithm>
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

std::vector<std::string_view> split_at_commas(std::string_view text) {
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

}  // namespace litfog::command
