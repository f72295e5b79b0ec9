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

/// An exposure at which one in twenty of the pixels that are not black has a channel above 0.8, the limit up to which a
/// display shows colours unchanged; but the middle one of all has a channel of at least 0.03 and at most 0.3 (levels 48
/// and 148 of sRGB), and then no more than one in a hundred has one above 5, which `neutral` still shows below white.
/// So a few bright lamps do not darken a picture, and a dark sky does not turn lit surfaces white.
///
/// returns  EV in hundredths, in [-kMaxExposure, kMaxExposure]; pixels that are not finite do not count; 0 if no other
///          pixel is lit
double auto_exposure(const Picture& picture);

/// Applies a tone curve to a colour that is already exposed, each channel finite and >= 0. Returns channels in [0, 1].
glm::vec3 toned(ToneCurve tone, const glm::vec3& color);

/// A picture as a display shows it, each channel in [0, 1]. Channels below 0 and NaN become 0, infinity becomes 1.
Picture displayed(const Picture& picture, const Display& display);

/// A value that a display shows, in [0, 1], as 8 bits of sRGB, dithered against banding.
///
/// index  of the value in Picture::rgb
std::uint8_t shown_level(float shown, std::uint32_t index);

}  // namespace litfog::render
