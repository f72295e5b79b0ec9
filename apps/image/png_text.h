// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace litfog::image {

/// The bytes of a .png file, by libpng. Levels are sRGB, RGB of 8 bits, rows from the top. Throws std::runtime_error
/// where libpng refuses.
std::string png_text(int width, int height, const std::vector<std::uint8_t>& levels);

}  // namespace litfog::image
