// SPDX-License-Identifier: Apache-2.0
#include "scene/texels.h"

#include <algorithm>
#include <cmath>

namespace litfog::scene {

std::uint8_t level_of(float fraction) { return std::uint8_t(std::clamp(fraction, 0.0f, 1.0f) * 255.0f + 0.5f); }

std::uint8_t srgb_level_of(float linear) {
  const float x = std::clamp(linear, 0.0f, 1.0f);
  return level_of(x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1.0f / 2.4f) - 0.055f);
}

}  // namespace litfog::scene
