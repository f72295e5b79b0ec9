// SPDX-License-Identifier: Apache-2.0
#include "command/number.h"

#include <algorithm>
#include <cmath>

#include "text/number_text.h"

namespace litfog::command {

std::optional<double> parse_number(std::string_view text) {
  const auto number = whole_number(text);
  return number && !std::isnan(*number) ? number : std::nullopt;
}

std::optional<int> parse_integer(std::string_view text) { return whole_number<int>(text); }

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
