// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "litfog/light.h"

namespace litfog::render {

/// The measure of a colour's brightness.
inline double largest_component(const glm::dvec3& color) { return std::max({color.r, color.g, color.b}); }

/// The attenuation at which a light ends in pictures by airlight: its own threshold, or a lower one at which its
/// colour's largest component is below 1/255 as shown, so that its end is not visible. Light beyond the end:
/// lights_fog_beyond_end() and lights_surfaces_beyond_end().
///
/// exposure  EV at which the picture is shown; below 0 counts as 0
inline double airlight_threshold(const Light& light, double exposure = 0) {
  const double invisible = std::exp2(-std::max(exposure, 0.0)) / 255;  // on a surface, which reflects only a fraction
  return std::min(light.threshold, invisible / std::max(largest_component(light.color), 1.0));
}

}  // namespace litfog::render
