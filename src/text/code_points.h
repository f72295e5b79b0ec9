// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace litfog {

/// Whether a byte of UTF-8 starts a code point.
constexpr bool starts_code_point(char byte) { return (static_cast<unsigned char>(byte) & 0xC0) != 0x80; }

/// Code points of a text: columns of a message or a table. Any bytes may be counted, UTF-8 or not.
constexpr std::size_t count_code_points(std::string_view text) {
  return std::size_t(std::ranges::count_if(text, starts_code_point));
}

}  // namespace litfog
