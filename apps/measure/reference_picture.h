// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "measure/progress.h"
#include "render/picture.h"
#include "render/renderer.h"

namespace litfog::measure {

/// A picture to compare others with.
struct ReferencePicture {
  render::Picture picture;
  /// The range of values that the texels of the path's light maps allow (LookupBounds). Without maps both are the
  /// picture itself.
  render::Picture least;
  render::Picture most;
  /// One per pixel: 1 if a sample is so close to a jump of the model that rounding decides its side (JumpWatch).
  std::vector<std::uint8_t> is_at_jump;
};

/// Shades a renderer's scene, without the points of its lamps, on the CPU in double by the plain formulas of its
/// lighting path: PathModel for surfaces and fog, night_sky for the sky.
///
/// Only the rasterised values of each sample are the GPU's, in floats: the position, the interpolated normal and
/// tangent, and the texels of the material's maps, because OpenGL leaves their filter and level of detail to the
/// driver.
///
/// A pixel's samples are averaged in double before clamping, as in the framebuffer.
///
/// throws  gl::Unsupported where the driver has no float framebuffer of the picture's size
ReferencePicture shade_reference(render::Renderer& renderer, const Progress& progress = {});

}  // namespace litfog::measure
