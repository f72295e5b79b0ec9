// SPDX-License-Identifier: Apache-2.0
#include "render/display.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <vector>

namespace litfog::render {
namespace {

constexpr float kBrightest = 1e30f;  // in place of infinity, whose ratios are no numbers

float largest_channel(const glm::vec3& color) { return std::max({color.r, color.g, color.b}); }

/// The value that a fraction of the values does not exceed. It reorders them; there is one at least.
float quantile(std::vector<float>& values, double fraction) {
  const auto at = values.begin() + std::ptrdiff_t(fraction * double(values.size() - 1));
  std::ranges::nth_element(values, at);
  return *at;
}

/// The names and figures are those of the published definition.
glm::vec3 neutral(glm::vec3 color) {
  constexpr float kF90 = 0.04f;
  constexpr float kStartCompression = 0.8f - kF90;
  constexpr float kDesaturation = 0.15f;
  constexpr float kD = 1 - kStartCompression;
  const float x = std::min({color.r, color.g, color.b});
  const float offset = x < 2 * kF90 ? x - x * x / (4 * kF90) : kF90;
  color -= offset;
  const float peak = largest_channel(color);
  if (peak < kStartCompression) return color;
  const float new_peak = 1 - kD * kD / (peak + kD - kStartCompression);
  color *= new_peak / peak;
  const float g = 1 - 1 / (kDesaturation * (peak - new_peak) + 1);
  return glm::mix(color, glm::vec3(new_peak), g);
}

}  // namespace

double auto_exposure(const Picture& picture) {
  std::vector<float> peaks;
  for (std::size_t i = 0; i < picture.rgb.size(); i += 3) {
    const glm::vec3 color(picture.rgb[i], picture.rgb[i + 1], picture.rgb[i + 2]);
    if (!std::isfinite(color.r) || !std::isfinite(color.g) || !std::isfinite(color.b)) continue;
    if (const float peak = largest_channel(color); peak > 0) peaks.push_back(peak);
  }
  if (peaks.empty()) return 0;
  const double gain = std::min(0.8 / double(quantile(peaks, 0.95)), 4 / double(quantile(peaks, 0.99)));
  const double ev = std::log2(gain);
  return std::clamp(std::round(100 * ev) / 100, -kMaxExposure, kMaxExposure);
}

glm::vec3 toned(ToneCurve tone, const glm::vec3& color) {
  return tone == ToneCurve::neutral ? neutral(color) : glm::min(color, 1.0f);
}

Picture displayed(const Picture& picture, const Display& display) {
  const auto gain = float(std::exp2(display.exposure.ev));
  const auto exposed = [gain](float value) { return value > 0 ? std::min(value * gain, kBrightest) : 0.0f; };
  Picture shown = picture;
  for (std::size_t i = 0; i < shown.rgb.size(); i += 3) {
    float* const rgb = &shown.rgb[i];
    const glm::vec3 color = toned(display.tone, {exposed(rgb[0]), exposed(rgb[1]), exposed(rgb[2])});
    for (int channel = 0; channel < 3; ++channel) rgb[channel] = color[channel];
  }
  return shown;
}

}  // namespace litfog::render
