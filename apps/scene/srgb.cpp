// SPDX-License-Identifier: Apache-2.0
#include "scene/srgb.h"

#include <algorithm>
#include <cmath>

namespace litfog::scene {

namespace {
namespace text {
using std::clamp;
using std::pow;
#include "scene/srgb.glsl"
}  // namespace text
}  // namespace

float srgb_from_linear(float linear) { return text::srgb_from_linear(linear); }

float linear_from_srgb(float srgb) {
  const float x = std::clamp(srgb, 0.0f, 1.0f);
  return x <= 0.04045f ? x / 12.92f : std::pow((x + 0.055f) / 1.055f, 2.4f);
}

}  // namespace litfog::scene
