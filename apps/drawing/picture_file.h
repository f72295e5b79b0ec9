// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "render/picture.h"

namespace litfog::drawing {

/// Writes a picture atomically: .png as 8-bit sRGB, dithered against banding (clamped to [0, 1]; render::displayed maps
/// into it); .exr as linear half floats, or floats if light exceeds those (65,504). Throws OutputError.
///
/// in_floats  .exr: always floats
void write_picture(const std::string& path, const render::Picture& picture, bool in_floats = false);

/// The bytes of a picture's .png file.
std::string png_text(const render::Picture& picture);

/// A picture's 8-bit pixels: RGB, top row first.
std::vector<std::uint8_t> shown_pixels(const render::Picture& picture);

/// Whether a path ends in .png or .exr.
bool is_picture_path(const std::string& path);

/// Whether a file holds the scene's light (.exr), not a displayed picture.
bool holds_scene_light(const std::string& path);

}  // namespace litfog::drawing
