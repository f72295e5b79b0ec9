// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "litfog/value_error.h"

namespace litfog {

/// What is wrong with a fit's target.
struct TargetError {
  ValueError error;
  std::optional<std::size_t> sample = std::nullopt;  ///< the sample with the field; absent: the target itself
};

/// The error as one sentence: "samples[3].attenuation = 0: must be in [1e-100, 1]".
std::string to_string(const TargetError& error);

}  // namespace litfog
