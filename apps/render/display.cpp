// SPDX-License-Identifier: Apache-2.0
#include "render/display.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <vector>

#include "scene/hash_random.h"
#include "scene/srgb.h"

namespace litfog::render {
namespace {

float largest_channel(const glm::vec3& color) { return std::max({color.r, color.g, color.b}); }

/// The quantile of values at a fraction in [0, 1]. Reorders the values, which must not be empty.
float quantile(std::vector<float>& values, double fraction) {
  const auto at = values.begin() + std::ptrdiff_t(fraction * double(values.size() - 1));
  std::ranges::nth_element(values, at);
  return *at;
}

namespace text {
using glm::floor;
using glm::max;
using glm::min;
using glm::mix;
using glm::vec3;
using scene::hash;
using scene::srgb_from_linear;
using scene::uint;
using scene::unit_float;
#include "render/shaders/display.glsl"
}  // namespace text

}  // namespace

double auto_exposure(const Picture& picture) {
  std::vector<float> peaks;
  for (std::size_t i = 0; i < picture.rgb.size(); i += 3) {
    const glm::vec3 color(picture.rgb[i], picture.rgb[i + 1], picture.rgb[i + 2]);
    if (!std::isfinite(color.r) || !std::isfinite(color.g) || !std::isfinite(color.b)) continue;
    if (const float peak = largest_channel(color); peak > 0) peaks.push_back(peak);
  }
  if (peaks.empty()) return 0;
  const double bright = 0.8 / double(quantile(peaks, 0.95));
  const auto middle = double(quantile(peaks, 0.5));
  const double gain = std::min(std::clamp(bright, 0.03 / middle, 0.3 / middle), 5 / double(quantile(peaks, 0.99)));
  const double ev = std::log2(gain);
  return std::clamp(std::round(100 * ev) / 100, -kMaxExposure, kMaxExposure);
}

glm::vec3 toned(ToneCurve tone, const glm::vec3& color) { return text::toned(tone == ToneCurve::neutral, color); }

Picture displayed(const Picture& picture, const Display& display) {
  const auto gain = float(std::exp2(display.exposure.ev));
  const auto exposed = [gain](float light) { return text::exposed(light, gain); };
  Picture shown = picture;
  for (std::size_t i = 0; i < shown.rgb.size(); i += 3) {
    float* const rgb = &shown.rgb[i];
    const glm::vec3 color = toned(display.tone, {exposed(rgb[0]), exposed(rgb[1]), exposed(rgb[2])});
    for (int channel = 0; channel < 3; ++channel) rgb[channel] = color[channel];
  }
  return shown;
}

std::uint8_t shown_level(float shown, std::uint32_t index) { return std::uint8_t(text::shown_level(shown, index)); }

}  // namespace litfog::render
