// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "render/picture.h"

namespace litfog::drawing {

/// Writes a picture atomically: .png as sRGB, 8 bits, dithered against banding (clamped to [0, 1]: render::displayed
/// makes it fit); .exr as linear half floats, or floats where light is beyond those (65,504). Throws OutputError.
///
/// in_floats  .exr: floats in any case
void write_picture(const std::string& path, const render::Picture& picture, bool in_floats = false);

/// The bytes of a .png file of it.
std::string png_text(const render::Picture& picture);

/// The bytes of its pixels: RGB, top row first.
std::vector<std::uint8_t> shown_pixels(const render::Picture& picture);

/// Whether a path has one of those endings.
bool is_picture_path(const std::string& path);

/// Whether the file holds the scene's light as it is (.exr) and not what a display shows of it.
bool holds_scene_light(const std::string& path);

}  // namespace litfog::drawing
