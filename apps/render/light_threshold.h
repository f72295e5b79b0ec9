// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "litfog/light.h"

namespace litfog::render {

/// By which a colour counts.
inline double largest_component(const glm::dvec3& color) { return std::max({color.r, color.g, color.b}); }

/// Where a light that is lit by airlight ends: at its own threshold, but not before its colour's largest component is
/// below 1/255, so that no end is seen at 0 EV on surfaces or in the fog.
inline double airlight_threshold(const Light& light) {
  constexpr double kInvisible = 1 / 255.0;  // on a surface, that reflects a part of it
  return std::min(light.threshold, kInvisible / std::max(largest_component(light.color), 1.0));
}

}  // namespace litfog::render
