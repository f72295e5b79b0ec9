// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/picture.h"
#include "measure/picture_error.h"
#include "render/renderer.h"
#include "scene/scene.h"

namespace litfog::demo {

/// A picture beside what its lighting path's plain formulas give in double. Both show the lamps' points; the error is
/// that of the shading before they are drawn: they are the same over every path, and no path's shading.
struct Comparison {
  Picture drawn;
  Picture reference;
  PictureError error;
};

/// Compares the frame that a renderer has drawn last with its reference (shade_reference, whose errors it throws, too).
///
/// scene, fog  the renderer's
Comparison compare_with_reference(const Scene& scene, const Fog& fog, Renderer& renderer);

}  // namespace litfog::demo
