// SPDX-License-Identifier: Apache-2.0
#include "drawing/lettering.h"

#include <glm/gtc/type_ptr.hpp>

#include "image/image_library.h"
#include "text/code_points.h"

namespace litfog::drawing {

void draw_text(render::Picture& picture, int left, int baseline, const std::string& text, int size,
               const glm::vec3& ink) {
  image::image_library().draw_text(picture.width, picture.height, picture.rgb, left, baseline, text, size,
                                   std::span<const float, 3>(glm::value_ptr(ink), 3));
}

std::string fitted_text(const std::string& text, int size, int width) {
  const auto fits = [&](const std::string& part) { return image::image_library().text_width(part, size) <= width; };
  std::string part = text;
  std::string shown = text;
  while (!fits(shown) && !part.empty()) {
    std::size_t end = part.size() - 1;
    while (end > 0 && !starts_code_point(part[end])) --end;
    part.resize(end);
    shown = part + "\u2026";
  }
  return shown;
}

}  // namespace litfog::drawing
