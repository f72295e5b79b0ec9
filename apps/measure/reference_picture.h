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
  /// The values between which the texels of the path's light maps leave the picture (LookupBounds). Without maps they
  /// are the picture itself.
  render::Picture least;
  render::Picture most;
  /// One a pixel: 1 where a sample lies so close to a jump of the model that the rounding of floats decides on which
  /// side (JumpWatch).
  std::vector<std::uint8_t> is_at_jump;
};

/// Shades what a renderer's scene shows, without the points of its lamps, on the CPU in double by the plain formulas of
/// its lighting path: Model for surfaces and fog, night_sky for the sky.
///
/// From the GPU come only what it rasterises, in floats, for each sample: the position, the vertices' normals and
/// tangents interpolated, and what its texture unit makes of the material's maps, whose filter and level of detail
/// OpenGL leaves to the driver.
///
/// A pixel's samples are averaged in double, before anything is clamped, as the framebuffer averages them.
///
/// throws  gl::Unsupported where the driver has no float framebuffer of the picture's size
ReferencePicture shade_reference(render::Renderer& renderer, const Progress& progress = {});

}  // namespace litfog::measure
