// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace litfog::scene {

/// IEC 61966-2-1, of values clamped to [0, 1].
float srgb_from_linear(float linear);
float linear_from_srgb(float srgb);

}  // namespace litfog::scene
