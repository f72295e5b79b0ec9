// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "litfog/light.h"

namespace litfog::render {

/// By which a colour counts.
inline double largest_component(const glm::dvec3& color) { return std::max({color.r, color.g, color.b}); }

/// Where a light of a picture by airlight ends: at its own threshold, but not before its colour's largest component is
/// below 1/255 as shown, so that no end is seen. What lies beyond: lights_fog_beyond_end(),
/// lights_surfaces_beyond_end().
///
/// exposure  EV at which the picture is shown; below 0 the end is that of 0 EV
inline double airlight_threshold(const Light& light, double exposure = 0) {
  const double invisible = std::exp2(-std::max(exposure, 0.0)) / 255;  // on a surface, that reflects a part of it
  return std::min(light.threshold, invisible / std::max(largest_component(light.color), 1.0));
}

}  // namespace litfog::render
