// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace litfog {

/// What is wrong with an argument. It owns no memory, so it can be reported without allocating.
struct ValueError {
  const char* field;  ///< which argument, e.g. "attenuation.linear"
  double value;       ///< the value given
  const char* rule;   ///< what it must be, e.g. "must be finite and >= 0"
};

/// The error as one sentence: "attenuation.linear = -1: must be finite and >= 0".
std::string to_string(const ValueError& error);

}  // namespace litfog
