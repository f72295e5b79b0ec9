// SPDX-License-Identifier: Apache-2.0
#include "measure/comparison.h"

#include "measure/reference_picture.h"

namespace litfog::measure {

Comparison compare_with_reference(render::Renderer& renderer, const Progress& progress) {
  render::Picture drawn = renderer.read();
  renderer.draw(render::LightPoints::off);
  const render::Picture shading = renderer.read();
  ReferencePicture reference = shade_reference(renderer, progress);
  const PictureError error = picture_error(shading, reference);
  std::vector<float>& rgb = reference.picture.rgb;
  for (std::size_t i = 0; i < rgb.size(); ++i) rgb[i] += drawn.rgb[i] - shading.rgb[i];
  return {std::move(drawn), std::move(reference.picture), error};
}

}  // namespace litfog::measure
