// SPDX-License-Identifier: Apache-2.0
#include "lettering.h"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include <stdexcept>

namespace litfog::demo {

void draw_text(Picture& picture, int left, int baseline, const std::string& text, int size, const glm::vec3& ink) {
  const OIIO::ImageSpec spec(picture.width, picture.height, 3, OIIO::TypeDesc::FLOAT);
  OIIO::ImageBuf image(spec, picture.rgb.data());  // draws into the picture's own pixels
  if (!OIIO::ImageBufAlgo::render_text(image, left, baseline, text, size, "DejaVuSans",
                                       OIIO::cspan<float>(&ink.x, 3))) {
    throw std::runtime_error("text cannot be drawn: " + image.geterror());
  }
}

}  // namespace litfog::demo
