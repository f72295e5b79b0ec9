// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "litfog/light.h"

namespace litfog::render {

/// The measure of a colour's brightness.
inline double largest_component(const glm::dvec3& color) { return std::max({color.r, color.g, color.b}); }

/// The attenuation at which a light ends in pictures by airlight: its own threshold, but low enough that its colour's
/// largest component is below 1/255 as shown, so that no end is seen. Beyond the end see lights_fog_beyond_end() and
/// lights_surfaces_beyond_end().
///
/// exposure  EV at which the picture is shown; taken as 0 if below
inline double airlight_threshold(const Light& light, double exposure = 0) {
  const double invisible = std::exp2(-std::max(exposure, 0.0)) / 255;  // on a surface, which reflects only part of it
  return std::min(light.threshold, invisible / std::max(largest_component(light.color), 1.0));
}

}  // namespace litfog::render
