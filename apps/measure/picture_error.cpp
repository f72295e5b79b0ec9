// SPDX-License-Identifier: Apache-2.0
#include "measure/picture_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <span>

#include "measure/reference_picture.h"
#include "scene/srgb.h"

namespace litfog::measure {
namespace {

/// Linear light, exposed, in steps of PictureError.
double steps(float linear) {
  constexpr double kSlopeAt1 = 1.055 / 2.4;  // slope of sRGB (IEC 61966-2-1)
  if (linear <= 1) return 255 * double(scene::srgb_from_linear(linear));
  return 255 * (1 + kSlopeAt1 * std::log(double(linear)));
}

std::span<const float> channels(const render::Picture& picture, std::size_t pixel) {
  return std::span(picture.rgb).subspan(3 * pixel, 3);
}

bool is_finite(const render::Picture& picture, std::size_t pixel) {
  return std::ranges::all_of(channels(picture, pixel), [](float value) { return std::isfinite(value); });
}

}  // namespace

PictureError picture_error(const render::Picture& drawn, const ReferencePicture& reference, double exposure) {
  const render::Picture& exact = reference.picture;
  assert(drawn.width == exact.width && drawn.height == exact.height);
  PictureError error{.width = drawn.width, .height = drawn.height};
  const auto gain = float(std::exp2(exposure));
  const auto exposed = [gain](const render::Picture& picture, std::size_t pixel, std::size_t channel) {
    return steps(gain * channels(picture, pixel)[channel]);
  };
  double sum = 0;
  for (std::size_t pixel = 0; pixel < reference.is_at_jump.size(); ++pixel) {
    double largest = 0;
    double beyond = 0;
    if (!is_finite(drawn, pixel) || !is_finite(exact, pixel) || !is_finite(reference.least, pixel) ||
        !is_finite(reference.most, pixel)) {
      largest = beyond = std::numeric_limits<double>::infinity();
    } else if (reference.is_at_jump[pixel]) {
      error.pixels.push_back(-1);
      ++error.excluded;
      continue;
    } else {
      for (std::size_t i = 0; i < 3; ++i) {
        const double value = exposed(drawn, pixel, i);
        largest = std::max(largest, std::abs(value - exposed(exact, pixel, i)));
        beyond =
            std::max({beyond, exposed(reference.least, pixel, i) - value, value - exposed(reference.most, pixel, i)});
      }
    }
    error.pixels.push_back(float(largest));
    error.largest = std::max(error.largest, largest);
    error.beyond_maps = std::max(error.beyond_maps, beyond);
    sum += largest;
  }
  const std::size_t compared = error.pixels.size() - error.excluded;
  error.mean = compared > 0 ? sum / double(compared) : 0;
  return error;
}

PictureError picture_error(const render::Picture& drawn, const render::Picture& other, double exposure) {
  const std::vector<std::uint8_t> no_jumps(other.rgb.size() / 3);
  return picture_error(drawn, {.picture = other, .least = other, .most = other, .is_at_jump = no_jumps}, exposure);
}

std::string error_in_words(const PictureError& error) {
  const std::string words = fmt::format("largest error {:.3g}, mean {:.3g} of 1/255", error.largest, error.mean);
  return error.excluded > 0 ? fmt::format("{}; pixels excluded: {}", words, error.excluded) : words;
}

Comparison compare_with_reference(render::Renderer& renderer, const Progress& progress) {
  render::Picture drawn = renderer.read();
  renderer.draw(render::LightPoints::off);
  const render::Picture shading = renderer.read();
  ReferencePicture reference = shade_reference(renderer, progress);
  PictureError error = picture_error(shading, reference, renderer.exposure());
  return {std::move(drawn), std::move(reference.picture), std::move(error)};
}

}  // namespace litfog::measure
