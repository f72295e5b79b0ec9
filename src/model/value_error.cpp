// SPDX-License-Identifier: Apache-2.0
#include "litfog/value_error.h"

#include "text/number_text.h"

namespace litfog {

std::string to_string(const ValueError& error) {
  return std::string(error.field) + " = " + number_text(error.value) + ": " + error.rule;
}

}  // namespace litfog
