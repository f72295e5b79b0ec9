// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "measure/reference_picture.h"
#include "render/picture.h"

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

}  // namespace litfog::measure
