// SPDX-License-Identifier: Apache-2.0
#include "demo/lettering.h"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include <stdexcept>

#include "code_points.h"

namespace litfog::demo {
namespace {

constexpr const char* kFont = "DejaVuSans";

}  // namespace

void draw_text(render::Picture& picture, int left, int baseline, const std::string& text, int size,
               const glm::vec3& ink) {
  const OIIO::ImageSpec spec(picture.width, picture.height, 3, OIIO::TypeDesc::FLOAT);
  OIIO::ImageBuf image(spec, picture.rgb.data());  // draws into the picture's own pixels
  if (!OIIO::ImageBufAlgo::render_text(image, left, baseline, text, size, kFont, OIIO::cspan<float>(&ink.x, 3))) {
    throw std::runtime_error("text cannot be drawn: " + image.geterror());
  }
}

std::string fitted_text(const std::string& text, int size, int width) {
  const auto fits = [&](const std::string& part) {
    return OIIO::ImageBufAlgo::text_size(part, size, kFont).width() <= width;
  };
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

}  // namespace litfog::demo
