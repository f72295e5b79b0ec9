// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "render/picture.h"

namespace litfog::window {

// Levels of light: luminance of linear sRGB after the exposure, in EV above a display's white.

inline constexpr double kLeastLevel = -12;
inline constexpr double kMostLevel = 4;

/// ev  the exposure
double light_level(const float* rgb, double ev);

/// A picture's levels as colours, by drawing::heat_color() from kLeastLevel to kMostLevel: bytes like
/// drawing::shown_pixels(), black below.
std::vector<std::uint8_t> false_colors(const render::Picture& light, double ev);

/// Fractions of a picture's pixels by their levels, from kLeastLevel to kMostLevel; levels beyond count at the ends.
std::array<float, 64> light_histogram(const render::Picture& light, double ev);

}  // namespace litfog::window
