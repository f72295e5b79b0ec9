// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "render/picture.h"
#include "scene/scene.h"

namespace litfog::render {

using scene::kMaxExposure;

/// Exposure of a picture in EV: its light is multiplied by 2^ev.
struct Exposure {
  double ev = 0;         ///< [-kMaxExposure, kMaxExposure]; if is_auto, as Renderer::set_exposure chose it
  bool is_auto = false;  ///< whether to choose ev from the picture

  friend bool operator==(const Exposure&, const Exposure&) = default;
};

/// How a display shows light beyond its white, which is 1.
///
/// neutral  Khronos PBR Neutral (Khronos 2024, "Khronos PBR Neutral Tone Mapper"): the least channel's light, at most
///          0.04, is subtracted as a surface's reflection at its Fresnel minimum; from a largest channel of 0.76 on the
///          colour is compressed towards 1, its hue kept, its saturation falling
/// clip     each channel is cut at 1, as in the papers; a bright orange becomes yellow
enum class ToneCurve { neutral, clip };

/// Maps scene values, linear and unbounded, to a display's light, linear in [0, 1].
struct Display {
  Exposure exposure = {};
  ToneCurve tone = ToneCurve::neutral;
};

/// Meters a picture. A pixel's value is its largest channel; black pixels do not count. The exposure puts the 95th
/// percentile at 0.8, up to which a display shows colours unchanged. It is limited first so that the median lies in
/// [0.03, 0.3] (levels 48 and 148 of sRGB), then so that the 99th percentile is at most 5, which `neutral` still shows
/// below white. So a few bright lamps do not darken a picture, and a dark sky does not turn lit surfaces white.
///
/// returns  EV in hundredths, in [-kMaxExposure, kMaxExposure]; pixels that are not finite do not count; 0 if no other
///          pixel is lit
double auto_exposure(const Picture& picture);

/// Applies a tone curve to a colour that is already exposed, each channel finite and >= 0. Returns channels in [0, 1].
glm::vec3 toned(ToneCurve tone, const glm::vec3& color);

/// A picture as a display shows it, each channel in [0, 1]. Channels below 0 and NaN become 0, infinity becomes 1.
Picture displayed(const Picture& picture, const Display& display);

/// Encodes a displayed value in [0, 1] as 8-bit sRGB, dithered against banding.
///
/// index  the value's index in Picture::rgb
std::uint8_t shown_level(float shown, std::uint32_t index);

}  // namespace litfog::render
