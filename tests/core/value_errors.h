// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>

namespace litfog::test {

/// The sentence with which a call refuses its arguments by std::invalid_argument.
template <typename Call>
std::string refusal_of(const Call& call) {
  try {
    call();
  } catch (const std::invalid_argument& refusal) {
    return refusal.what();
  }
  return "not refused";
}

}  // namespace litfog::test
