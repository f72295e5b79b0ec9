// SPDX-License-Identifier: Apache-2.0
#include "command/html_text.h"

#include <fmt/format.h>

#include "command/printable.h"

namespace litfog::command {

std::string html_text(std::string_view text) {
  std::string html;
  for (const char c : printable_lines(text)) {
    switch (c) {
      case '&':
        html += "&amp;";
        break;
      case '<':
        html += "&lt;";
        break;
      case '>':
        html += "&gt;";
        break;
      case '"':
        html += "&quot;";
        break;
      case '\'':
        html += "&#39;";
        break;
      default:
        html += c;
    }
  }
  return html;
}

std::string html_link(std::string_view file) {
  constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-._~";
  std::string link;
  for (const char c : file) {
    if (kPlain.find(c) != kPlain.npos) {
      link += c;
    } else {
      link += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
  }
  return link;
}

}  // namespace litfog::command
