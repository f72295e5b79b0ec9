// SPDX-License-Identifier: Apache-2.0
#include "command/printable.h"

#include <fmt/format.h>
#include <utf8.h>

#include <cstdint>

namespace litfog::command {

namespace {

bool is_control(char32_t c) { return c < 0x20 || (c >= 0x7F && c < 0xA0); }
bool is_noncharacter(char32_t c) { return (c & 0xFFFE) == 0xFFFE || (c >= 0xFDD0 && c <= 0xFDEF); }

std::string escaped(std::string_view text, std::string_view kept) {
  std::string result;
  for (auto at = text.begin(); at != text.end();) {
    const auto begin = at;
    char32_t c = 0;
    try {
      c = utf8::next(at, text.end());
    } catch (const utf8::exception&) {
      result += fmt::format("\\x{:02x}", static_cast<unsigned char>(*begin));
      at = begin + 1;
      continue;
    }
    if (c < 0x80 && kept.find(char(c)) != kept.npos) {
      result += char(c);
    } else if (is_control(c) || is_noncharacter(c)) {
      const auto code = std::uint32_t(c);
      result += c < 0x80 ? fmt::format("\\x{:02x}", code) : fmt::format("\\u{:04x}", code);
    } else {
      result.append(begin, at);
    }
  }
  return result;
}

}  // namespace

std::string printable(std::string_view text) { return escaped(text, ""); }

std::string printable_lines(std::string_view text) { return escaped(text, "\n"); }

}  // namespace litfog::command
