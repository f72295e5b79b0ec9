// SPDX-License-Identifier: Apache-2.0
#include "scene/texels.h"

#include <algorithm>

#include "scene/srgb.h"

namespace litfog::scene {

std::uint8_t level_of(float fraction) { return std::uint8_t(std::clamp(fraction, 0.0f, 1.0f) * 255.0f + 0.5f); }

std::uint8_t srgb_level_of(float linear) { return level_of(srgb_from_linear(linear)); }

}  // namespace litfog::scene
