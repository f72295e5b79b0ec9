// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec3.hpp>
#include <string>

#include "render/picture.h"

namespace litfog::drawing {

/// Writes a text into a picture in a plain type.
///
/// left, baseline, size  pixels; baseline is where the letters stand, size about the height of a line
/// ink                   linear RGB
/// throws                image::ImageError where no font is found
void draw_text(render::Picture& picture, int left, int baseline, const std::string& text, int size,
               const glm::vec3& ink);

/// The text, or as much of its beginning as fits into a width in pixels, and an ellipsis.
std::string fitted_text(const std::string& text, int size, int width);

}  // namespace litfog::drawing
