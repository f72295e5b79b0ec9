// SPDX-License-Identifier: Apache-2.0
#include "drawing/heat_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <numbers>

#include "drawing/lettering.h"
#include "scene/srgb.h"

namespace litfog::drawing {
namespace {

constexpr int kMinWidth = 640;  // pixels, for the text
constexpr int kMaxMagnifiedHeight = 2048;
constexpr int kMargin = 10;
constexpr int kFontSize = 14;
constexpr int kLineHeight = 22;
constexpr int kBarHeight = 14;
constexpr glm::vec3 kGround{0.012f, 0.012f, 0.014f};
constexpr glm::vec3 kInk{0.75f, 0.75f, 0.72f};
constexpr glm::vec3 kExcluded{1, 0, 0};

/// error  -1: excluded
glm::vec3 color_of(double error) {
  return error < 0 ? kExcluded : heat_color(std::clamp(std::log10(error / kHeatLeast) / kHeatDecades, 0.0, 1.0));
}

/// Fills columns [left, right) of rows [top, bottom).
void fill(render::Picture& picture, int left, int top, int right, int bottom, const glm::vec3& color) {
  for (int y = top; y < bottom; ++y) {
    for (int x = left; x < right; ++x) {
      const std::size_t at = (std::size_t(y) * std::size_t(picture.width) + std::size_t(x)) * 3;
      for (int channel = 0; channel < 3; ++channel) picture.rgb[at + std::size_t(channel)] = color[channel];
    }
  }
}

void draw_scale(render::Picture& picture, int top) {
  const int left = kMargin;
  const int length = kMinWidth - 8 * kMargin;
  const glm::vec3 frame = kInk * 0.3f;  // because the scale begins as dark as the background
  fill(picture, left - 1, top - 1, left + length + 2, top + kBarHeight + 1, frame);
  for (int i = 0; i <= length; ++i) {
    fill(picture, left + i, top, left + i + 1, top + kBarHeight, heat_color(double(i) / length));
  }
  for (int decade = 0; decade <= kHeatDecades; ++decade) {
    const int x = left + int(length * decade / kHeatDecades);
    fill(picture, x, top + kBarHeight, x + 1, top + kBarHeight + 5, kInk);
    const std::string label = fmt::format("{:g}", kHeatLeast * std::pow(10.0, decade));
    draw_text(picture, x + 4, top + kBarHeight + kFontSize, decade == 0 ? label + " of 1/255" : label, kFontSize, kInk);
  }
}

}  // namespace

glm::vec3 heat_color(double fraction) {
  constexpr double kStart = 0.5;  // Green's default scheme
  constexpr double kRotations = -1.5;
  const double angle = 2 * std::numbers::pi * (kStart / 3 + 1 + kRotations * fraction);
  const double amplitude = fraction * (1 - fraction) / 2;
  const glm::dvec3 color = fraction + amplitude * (glm::dvec3(-0.14861, -0.29227, 1.97294) * std::cos(angle) +
                                                   glm::dvec3(1.78277, -0.90649, 0) * std::sin(angle));
  const glm::vec3 shown(glm::clamp(color, 0.0, 1.0));
  return {scene::linear_from_srgb(shown.r), scene::linear_from_srgb(shown.g), scene::linear_from_srgb(shown.b)};
}

render::Picture heat_picture(const measure::PictureError& error) {
  render::Picture picture{error.width, error.height, {}};
  picture.rgb.reserve(error.pixels.size() * 3);
  for (const float value : error.pixels) {
    const glm::vec3 color = color_of(double(value));
    picture.rgb.insert(picture.rgb.end(), {color.r, color.g, color.b});
  }
  return picture;
}

render::Picture make_heat_map(const measure::PictureError& error, const std::string& title) {
  const int to_least_width = (kMinWidth + error.width - 1) / error.width;
  const int magnified = std::clamp(kMaxMagnifiedHeight / error.height, 1, to_least_width);
  const int width = std::max(error.width * magnified, kMinWidth);
  const int height = error.height * magnified;
  render::Picture picture{width, height + 2 * kLineHeight + kBarHeight + 3 * kMargin, {}};
  picture.rgb.resize(std::size_t(picture.width) * std::size_t(picture.height) * 3);
  fill(picture, 0, 0, picture.width, picture.height, kGround);
  for (int y = 0; y < error.height; ++y) {
    for (int x = 0; x < error.width; ++x) {
      const float value = error.pixels[std::size_t(y) * std::size_t(error.width) + std::size_t(x)];
      fill(picture, x * magnified, y * magnified, (x + 1) * magnified, (y + 1) * magnified, color_of(double(value)));
    }
  }
  const std::string words = title + ": " + measure::error_in_words(error) + (error.excluded > 0 ? " (red)" : "");
  draw_text(picture, kMargin, height + kLineHeight, words, kFontSize, kInk);
  draw_scale(picture, height + kLineHeight + kMargin);
  return picture;
}

}  // namespace litfog::drawing
