// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec3.hpp>
#include <string>

#include "render/picture.h"

namespace litfog::drawing {

/// Writes a text into a picture.
///
/// left, baseline, size  pixels; size is about the height of a line
/// ink                   linear RGB
/// throws                image::ImageError if no font is found
void draw_text(render::Picture& picture, int left, int baseline, const std::string& text, int size,
               const glm::vec3& ink);

/// The text, or as much of its beginning as fits into a width in pixels with an ellipsis.
std::string fitted_text(const std::string& text, int size, int width);

}  // namespace litfog::drawing
