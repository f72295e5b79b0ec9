// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include "command/plot.h"
#include "fit/light_fit.h"
#include "litfog/light.h"

namespace litfog::fit {

/// Targets and fits, and below them the errors, over range and over angle; and the beam as a polar diagram, above its
/// spread over the turn. Of several lights, one in each colour, the profile that each fit chose.
///
/// fits  at least one
command::Figure fit_figure(const std::vector<const LightFit*>& fits);

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
