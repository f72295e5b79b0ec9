// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>

#include "litfog/fog_light_block.h"
#include "litfog/value_error.h"

namespace litfog {

/// What is wrong with a number of entries of the uniform block, or nothing.
inline std::optional<ValueError> check_fog_light_count(const char* field, std::size_t count) {
  static_assert(kMaxFogLights == 200);
  if (count > kMaxFogLights) return ValueError{field, double(count), "must be at most 200"};
  return std::nullopt;
}

}  // namespace litfog
