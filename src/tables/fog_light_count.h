// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "litfog/fog_light_block.h"
#include "model/require.h"

namespace litfog {

/// Throws if the uniform block has no room for this number of entries.
inline void require_fog_light_count(const char* field, std::size_t count) {
  static_assert(kMaxFogLights == 200);
  if (count > kMaxFogLights) fail_count(field, count, "must be at most 200");
}

}  // namespace litfog
