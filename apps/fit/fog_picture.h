// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>

#include "litfog/light.h"

namespace litfog::fit {

/// Visibilities of the three views of a light in fog, metres.
inline constexpr std::array<double, 3> kFogPictureVisibilities{1000, 200, 50};
/// Size of one view, in pixels, and the width that it shows at the light, in metres.
inline constexpr int kFogPictureWidth = 160;
inline constexpr int kFogPictureHeight = 90;
inline constexpr double kFogPictureMetres = 40;

/// A light in exp fog of three visibilities, side by side, as a PNG file: its airlight (litfog/airlight.h) as an eye
/// sees it that looks at the beam from 30 m beside it. All lights are drawn in the same size and at the same exposure.
std::string draw_fog_picture(const Light& light);

}  // namespace litfog::fit
