// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "measure/progress.h"
#include "render/picture.h"
#include "render/renderer.h"

namespace litfog::measure {

struct Tracing {
  int paths = 256;  ///< per pixel, at least 1
  std::uint32_t seed = 1;
};

/// Light of a scene's lamps that reaches the eye after more than one scattering or reflection, by a path tracer (Monte
/// Carlo): unlike the formulas of litfog it knows the ground, walls and shadows, in which fog scatters and surfaces
/// reflect light any number of times. Added to a picture with shadows that is scattered once (Scattering::single), it
/// makes the true picture, up to highlights and panes. A surface that the eye does not see directly reflects as its
/// material does on average, without colours of materials and vertices.
///
/// Each path is one of walk_scattering() from the eye to one lamp. It begins in the fog or on the surface that the eye
/// sees. Lamps are drawn by what the formulas expect of them in the pixel, which changes the noise, not the mean.
///
/// renderer  by airlight and Scattering::all; no cookies
/// throws    std::invalid_argument naming field, value and rule
render::Picture trace_higher_orders(render::Renderer& renderer, const Tracing& tracing = {},
                                    const Progress& progress = {});

}  // namespace litfog::measure
