// SPDX-License-Identifier: Apache-2.0
#include "window/light_levels.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "drawing/heat_map.h"
#include "drawing/picture_file.h"

namespace litfog::window {
namespace {

/// The index of a level's part of the scale.
std::size_t part_of(double level, std::size_t parts) {
  const double fraction = (level - kLeastLevel) / (kMostLevel - kLeastLevel);
  return fraction > 0 ? std::min(std::size_t(fraction * double(parts)), parts - 1) : 0;  // a NaN is dark
}

}  // namespace

double light_level(const float* rgb, double ev) {  // Rec. 709
  return std::log2(0.2126 * double(rgb[0]) + 0.7152 * double(rgb[1]) + 0.0722 * double(rgb[2])) + ev;
}

std::vector<std::uint8_t> false_colors(const render::Picture& light, double ev) {
  constexpr std::size_t kColors = 256;
  static const std::vector<std::uint8_t> colors = [] {
    render::Picture scale{.width = int(kColors), .height = 1, .rgb = {}};
    for (std::size_t i = 0; i < kColors; ++i) {
      const glm::vec3 color = drawing::heat_color(double(i) / double(kColors - 1));
      scale.rgb.insert(scale.rgb.end(), {color.r, color.g, color.b});
    }
    return drawing::shown_pixels(scale);
  }();
  std::vector<std::uint8_t> pixels;
  pixels.reserve(light.rgb.size());
  for (std::size_t i = 0; i < light.rgb.size(); i += 3) {
    const auto color = std::span(colors).subspan(3 * part_of(light_level(&light.rgb[i], ev), kColors), 3);
    pixels.insert(pixels.end(), color.begin(), color.end());
  }
  return pixels;
}

std::array<float, 64> light_histogram(const render::Picture& light, double ev) {
  std::array<float, 64> fractions{};
  const float pixel = 3 / float(std::max<std::size_t>(light.rgb.size(), 1));
  for (std::size_t i = 0; i < light.rgb.size(); i += 3) {
    fractions[part_of(light_level(&light.rgb[i], ev), fractions.size())] += pixel;
  }
  return fractions;
}

}  // namespace litfog::window
