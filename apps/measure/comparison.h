// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "measure/picture_error.h"
#include "measure/progress.h"
#include "render/picture.h"
#include "render/renderer.h"

namespace litfog::measure {

/// A picture beside what its lighting path's plain formulas give in double. Both show the lamps' points; the error is
/// that of the shading before they are drawn: they are the same over every path, and no path's shading.
struct Comparison {
  render::Picture drawn;
  render::Picture reference;
  PictureError error;
};

/// Compares the frame that a renderer has drawn last with its reference.
///
/// throws  what shade_reference throws
Comparison compare_with_reference(render::Renderer& renderer, const Progress& progress = {});

}  // namespace litfog::measure
