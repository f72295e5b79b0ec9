// SPDX-License-Identifier: Apache-2.0
#include "measure/comparison.h"

#include <fmt/format.h>

#include "command/progress.h"
#include "measure/reference_picture.h"

namespace litfog::measure {

Comparison compare_with_reference(const scene::Scene& scene, const Fog& fog, render::Renderer& renderer) {
  render::Picture drawn = renderer.read();
  renderer.draw(render::LightPoints::off);
  const render::Picture shading = renderer.read();
  command::Progress progress;
  ReferencePicture reference = shade_reference(scene, fog, renderer, [&](double share) {
    progress.show(fmt::format("shading the reference: {:.0f} %", 100 * share));
  });
  const PictureError error = picture_error(shading, reference);
  std::vector<float>& rgb = reference.picture.rgb;
  for (std::size_t i = 0; i < rgb.size(); ++i) rgb[i] += drawn.rgb[i] - shading.rgb[i];
  return {std::move(drawn), std::move(reference.picture), error};
}

}  // namespace litfog::measure
