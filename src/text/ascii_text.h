// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

namespace litfog {

/// A text with ASCII capitals in lower case, whatever the locale.
inline std::string lower(std::string_view text) {
  std::string result(text);
  std::ranges::transform(result, result.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
  return result;
}

/// A text without the white space around it. For a text of only white space, its empty end.
constexpr std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlank = " \t\r\n";
  const auto begin = std::min(text.find_first_not_of(kBlank), text.size());
  return text.substr(begin, text.find_last_not_of(kBlank) + 1 - begin);
}

/// The end of a line that begins at a position: the first line feed or carriage return, or the text's end.
/// find_first_of() would search its set for each character.
inline std::size_t find_line_end(std::string_view text, std::size_t begin = 0) {
  const auto ends_line = [](char c) { return c == '\n' || c == '\r'; };
  return std::size_t(std::find_if(text.begin() + std::ptrdiff_t(begin), text.end(), ends_line) - text.begin());
}

}  // namespace litfog
