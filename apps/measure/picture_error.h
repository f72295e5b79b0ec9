// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "measure/progress.h"
#include "measure/reference_picture.h"
#include "render/picture.h"
#include "render/renderer.h"

namespace litfog::measure {

/// How far a picture is from its reference, in steps of 1/255 of what a display shows.
///
/// Light is multiplied by 2^exposure first. Up to 1 these are steps of linear light encoded as sRGB, the values that a
/// PNG holds before they are rounded. (A night scene is dark, and 1/255 of linear light would pass errors there that
/// are 13 steps on the display.) Above 1, where a display shows no more, steps are relative: the scale goes on as a
/// logarithm with the slope that sRGB has at 1, and a step is 0.9 % of the light. Light below 0 counts as 0.
struct PictureError {
  int width = 0;
  int height = 0;
  std::vector<float> pixels = {};  ///< the largest of the three channels' errors; -1 where the pixel is excluded
  /// Infinite, like the mean, where any pixel of either picture, even an excluded one, is infinite or NaN.
  double largest = 0;
  double mean = 0;
  double beyond_maps = 0;    ///< the largest beyond what the path's light maps leave open; `largest` without maps
  std::size_t excluded = 0;  ///< pixels at a jump of the model (ReferencePicture::is_at_jump)
};

/// Compares two pictures of one size.
///
/// exposure  EV at which they are shown
PictureError picture_error(const render::Picture& drawn, const ReferencePicture& reference, double exposure = 0);

/// "largest error 0.139, mean 0.0126 of 1/255", and how many pixels are excluded if any are.
std::string error_in_words(const PictureError& error);

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
