// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "image/image_library.h"

namespace litfog::image {

/// PNG by libpng, with nothing printed: OpenImageIO lets libpng write to standard error before it tells of an error.

/// The bytes of a .png file. Levels are sRGB, RGB of 8 bits, rows from the top. Throws ImageError where libpng refuses.
std::string png_text(int width, int height, const std::vector<std::uint8_t>& levels);

/// The levels of a .png file as they are, whatever it says of gamma and profiles; of 16 bits rounded to 8.
///
/// accept  is called with width and height before memory for the levels is taken; what it throws is passed on
/// throws  ImageError
Levels decode_png(std::string_view bytes, const std::function<void(int, int)>& accept);

}  // namespace litfog::image
