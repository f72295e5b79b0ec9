// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "measure/progress.h"
#include "render/gpu/geometry_buffer.h"
#include "render/picture.h"
#include "render/renderer.h"

namespace litfog::measure {

/// A picture to compare others with.
struct ReferencePicture {
  render::Picture picture;
  /// Between which values the texels of the path's light maps leave the picture: a look-up lies between the light's
  /// values at the texels around it. Of paths without maps the picture itself.
  render::Picture least;
  render::Picture most;
  /// A pixel each: 1 where a sample lies so close to a jump of the model (a light's extent, the edge of a cosine cone,
  /// the line beyond which a surface is turned away) that the rounding of floats decides on which side.
  std::vector<std::uint8_t> is_at_jump;
};

/// Shades what a renderer's scene shows, without its light points, on the CPU in double by the plain formulas of its
/// lighting path: every light on every sample by the path's range law up to its extent, its cone and the path's surface
/// model; the fog by the exact intensities of the carried lights; the sky. No shader's result is used but what the
/// geometry buffer holds: places, normals and colours as rasterised, in floats.
/// The samples of a pixel are averaged in double, before anything is clamped, as the framebuffer does.
///
/// throws  gl::Unsupported where the driver has no float framebuffer of the picture's size
ReferencePicture shade_reference(render::Renderer& renderer, const Progress& progress = {});

}  // namespace litfog::measure
