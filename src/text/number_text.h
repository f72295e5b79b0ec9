// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <charconv>
#include <string>

namespace litfog {

/// The shortest text that reads back as the same number, in any locale: "0.1", "1e-30", "inf", "nan".
inline std::string number_text(double number) {
  std::array<char, 32> text;  // 24 characters at most
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), number).ptr};
}

}  // namespace litfog
