// SPDX-License-Identifier: Apache-2.0
#include "litfog/value_error.h"

#include <array>
#include <charconv>

namespace litfog {

std::string to_string(const ValueError& error) {
  std::array<char, 32> digits;  // the shortest text that reads back exactly is at most 24 characters
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), error.value).ptr;
  return std::string(error.field) + " = " + std::string(digits.data(), end) + ": " + error.rule;
}

}  // namespace litfog
