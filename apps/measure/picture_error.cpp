// SPDX-License-Identifier: Apache-2.0
#include "measure/picture_error.h"

#include <OpenImageIO/color.h>
#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace litfog::measure {
namespace {

double shown(float linear) { return 255 * double(OIIO::linear_to_sRGB(std::clamp(linear, 0.0f, 1.0f))); }

}  // namespace

PictureError picture_error(const render::Picture& drawn, const ReferencePicture& reference) {
  const render::Picture& exact = reference.picture;
  assert(drawn.width == exact.width && drawn.height == exact.height);
  PictureError error{.width = drawn.width, .height = drawn.height};
  double sum = 0;
  for (std::size_t pixel = 0; pixel < reference.is_at_jump.size(); ++pixel) {
    if (reference.is_at_jump[pixel]) {
      error.pixels.push_back(-1);
      ++error.excepted;
      continue;
    }
    double largest = 0;
    double beyond = 0;
    for (std::size_t i = 3 * pixel; i < 3 * pixel + 3; ++i) {
      const double value = shown(drawn.rgb[i]);
      if (std::isnan(drawn.rgb[i])) {
        largest = beyond = std::numeric_limits<double>::infinity();
        break;
      }
      largest = std::max(largest, std::abs(value - shown(exact.rgb[i])));
      beyond = std::max({beyond, shown(reference.least.rgb[i]) - value, value - shown(reference.most.rgb[i])});
    }
    error.beyond_maps = std::max(error.beyond_maps, beyond);
    error.pixels.push_back(float(largest));
    error.largest = std::max(error.largest, largest);
    sum += largest;
  }
  const std::size_t compared = error.pixels.size() - error.excepted;
  error.mean = compared > 0 ? sum / double(compared) : 0;
  return error;
}

std::string error_in_words(const PictureError& error) {
  const std::string words = fmt::format("largest error {:.3g}, mean {:.3g} of 1/255", error.largest, error.mean);
  return error.excepted > 0 ? fmt::format("{}; pixels excepted: {}", words, error.excepted) : words;
}

}  // namespace litfog::measure
