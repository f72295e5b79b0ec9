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

/// Error of a picture against its reference, in displayed steps of 1/255.
///
/// Light is first multiplied by 2^exposure. Up to 1, steps are of light encoded as sRGB, the values of a PNG before
/// rounding. (In dark night scenes 1/255 of linear light would be 13 steps on the display.) Above 1, where a display
/// clips, steps are relative: the scale continues as a logarithm with the slope of sRGB at 1, and a step is 0.9 % of
/// the light. Light below 0 counts as 0.
struct PictureError {
  int width = 0;
  int height = 0;
  std::vector<float> pixels = {};  ///< the largest of the three channels' errors; -1 where the pixel is excluded
  /// Infinite, like the mean, if any pixel of either picture, even an excluded one, is infinite or NaN.
  double largest = 0;
  double mean = 0;
  double beyond_maps = 0;    ///< largest error outside the range of the light maps; `largest` without maps
  std::size_t excluded = 0;  ///< pixels at a jump of the model (ReferencePicture::is_at_jump)
};

/// Compares two pictures of one size.
///
/// exposure  EV of the display
PictureError picture_error(const render::Picture& drawn, const ReferencePicture& reference, double exposure = 0);
PictureError picture_error(const render::Picture& drawn, const render::Picture& other, double exposure = 0);

/// "largest error 0.139, mean 0.0126 of 1/255", and the number of excluded pixels if there are any.
std::string error_in_words(const PictureError& error);

/// A frame and its reference by the lighting path's plain formulas in double. Reference and error leave out the points
/// of lamps: every path draws them alike, and no path shades them.
struct Comparison {
  render::Picture drawn;  ///< with the lamps' points
  render::Picture reference;
  PictureError error;  ///< error of the frame without the lamps' points, at the renderer's exposure
};

/// Compares a renderer's last frame with its reference.
///
/// throws  like shade_reference
Comparison compare_with_reference(render::Renderer& renderer, const Progress& progress = {});

}  // namespace litfog::measure
