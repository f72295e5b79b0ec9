// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "image/image_library.h"

namespace litfog::image {

/// PNG by libpng, with nothing printed: OpenImageIO lets libpng write to standard error before it reports an error.

/// The bytes of a .png file. Levels are 8-bit sRGB, top row first. Throws ImageError if libpng refuses.
std::string png_text(int width, int height, const std::vector<std::uint8_t>& levels);

/// The levels of a .png file as stored, ignoring gamma and profiles; 16 bits are rounded to 8.
///
/// accept  called with width and height before memory is allocated; may throw
/// throws  ImageError
Levels decode_png(std::string_view bytes, const std::function<void(int, int)>& accept);

}  // namespace litfog::image
