// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace litfog::render {

/// Linear RGB, top row first.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<float> rgb;
};

/// Writes a picture whole or not at all: .png as sRGB, 8 bits, dithered against banding (clamped to [0, 1]); .exr as
/// linear half floats. Throws CannotWrite.
void write_picture(const std::string& path, const Picture& picture);

/// Whether a path has one of those endings.
bool is_picture_path(const std::string& path);

}  // namespace litfog::render
