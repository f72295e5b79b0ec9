// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "measure/picture_error.h"
#include "measure/progress.h"
#include "render/picture.h"
#include "render/renderer.h"

namespace litfog::measure {

/// A frame beside what its lighting path's plain formulas give in double. The points of lamps are left out of the
/// reference and of the error: every path draws them alike, and no path shades them.
struct Comparison {
  render::Picture drawn;  ///< with the lamps' points
  render::Picture reference;
  PictureError error;  ///< error of the frame without the lamps' points, at the renderer's exposure
};

/// Compares the frame that a renderer has drawn last with its reference.
///
/// throws  what shade_reference throws
Comparison compare_with_reference(render::Renderer& renderer, const Progress& progress = {});

}  // namespace litfog::measure
