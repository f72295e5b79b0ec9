// SPDX-License-Identifier: Apache-2.0
#include "litfog/fit/target_error.h"

namespace litfog {

std::string to_string(const TargetError& error) {
  const std::string sentence = to_string(error.error);
  return error.sample ? "samples[" + std::to_string(*error.sample) + "]." + sentence : sentence;
}

}  // namespace litfog
