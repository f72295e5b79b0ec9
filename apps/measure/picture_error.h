// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "measure/reference_picture.h"
#include "render/picture.h"

namespace litfog::measure {

/// How far a picture is from its reference, in steps of 1/255 of what a display shows: linear light clamped to [0, 1]
/// and encoded as sRGB, the values that a PNG holds before they are rounded. A night scene is dark, and in linear light
/// 1/255 would pass errors there that are 13 steps on the display.
struct PictureError {
  int width = 0;
  int height = 0;
  std::vector<float> pixels = {};  ///< the largest of the three channels' errors; -1 where the pixel is excepted
  double largest = 0;              ///< infinity where a pixel is not a number
  double mean = 0;
  double beyond_maps = 0;    ///< the largest beyond what the path's light maps leave open; `largest` without maps
  std::size_t excepted = 0;  ///< pixels at a jump of the model (ReferencePicture::is_at_jump)
};

/// Compares two pictures of one size.
PictureError picture_error(const render::Picture& drawn, const ReferencePicture& reference);

/// "largest error 0.139, mean 0.0126 of 1/255", and how many pixels are excepted if any are.
std::string error_in_words(const PictureError& error);

}  // namespace litfog::measure
