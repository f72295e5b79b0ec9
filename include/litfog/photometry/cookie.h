// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "litfog/photometry/intensity_distribution.h"

namespace litfog {

/// A light's full angular shape as a cube map (Frazier 2000, "Real-Time Per-Pixel Point Lights and Spot Lights").
struct Cookie {
  int size = 0;  ///< texels along an edge
  /// Intensity over the distribution's peak, [0, 1]: 6 * size * size texels, faces +x -x +y -y +z -z, each with its
  /// rows and columns as glTexImage2D takes them (OpenGL 4.6, table 8.19).
  std::vector<float> texels;
};

/// Samples a distribution at the centres of a cube map's texels. The light's frame is the luminaire frame: the axis is
/// -z, as the default direction of a placed light is, and +y is up.
///
/// size       [1, 4096]
/// throws     std::invalid_argument naming field, value and rule
Cookie bake_cookie(const IntensityDistribution& distribution, int size);

}  // namespace litfog
