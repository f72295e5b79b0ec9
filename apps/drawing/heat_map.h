// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec3.hpp>
#include <string>

#include "measure/picture_error.h"
#include "render/picture.h"

namespace litfog::drawing {

inline constexpr double kHeatLeast = 0.1;  ///< 1/255: the least error on the scale of colours
inline constexpr int kHeatDecades = 3;     ///< the length of the scale, in factors of 10

/// The errors of a picture as colours from black (0.1/255 and less) to white (100/255 and more), with their logarithmic
/// scale below. Excluded pixels are red. Small pictures are magnified to the width of the text under them, up to a
/// height of 2048 pixels.
///
/// title   what is compared; followed by the largest and the mean error
/// throws  std::runtime_error if no font is found
render::Picture make_heat_map(const measure::PictureError& error, const std::string& title);

/// The colours alone, one per pixel.
render::Picture heat_picture(const measure::PictureError& error);

/// The colour of a fraction of the scale: cubehelix (Green 2011, "A colour scheme for the display of astronomical
/// intensity images"), through all hues, ever brighter. Linear RGB.
///
/// fraction  [0, 1]
glm::vec3 heat_color(double fraction);

}  // namespace litfog::drawing
