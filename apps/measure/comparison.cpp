// SPDX-License-Identifier: Apache-2.0
#include "measure/comparison.h"

#include "measure/reference_picture.h"

namespace litfog::measure {

Comparison compare_with_reference(render::Renderer& renderer, const Progress& progress) {
  render::Picture drawn = renderer.read();
  renderer.draw(render::LightPoints::off);
  const render::Picture shading = renderer.read();
  ReferencePicture reference = shade_reference(renderer, progress);
  PictureError error = picture_error(shading, reference, renderer.exposure());
  return {std::move(drawn), std::move(reference.picture), std::move(error)};
}

}  // namespace litfog::measure
