// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>

#include "litfog/airlight.h"

namespace litfog {

/// Throws for the first wrong ray, and of several names its index.
inline void require_rays(std::span<const EyeRay> rays) {
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const auto error = find_error(rays[i]);
    if (!error) continue;
    const std::string place = rays.size() > 1 ? "rays[" + std::to_string(i) + "]." : "";
    throw std::invalid_argument(place + to_string(*error));
  }
}

}  // namespace litfog
