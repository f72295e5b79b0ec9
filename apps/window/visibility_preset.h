// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <limits>
#include <optional>

#include "litfog/runway_visual_range.h"

namespace litfog::window {

/// A named visibility or runway visual range.
struct VisibilityPreset {
  const char* name;
  double metres;
  bool is_runway_visual_range;
  const char* meaning;  ///< one sentence

  /// The visibility in a fog mode, by a contrast, metres; nothing if the lamps are not visible so far in clear air.
  std::optional<double> visibility(FogMode mode, double contrast, const RunwayLights& lights = {}) const {
    if (!is_runway_visual_range) return metres;
    if (find_runway_visual_range_error(metres, lights)) return std::nullopt;
    return litfog::visibility(fog_from_runway_visual_range(mode, metres, lights), contrast);
  }
};

// The slider's ends. Clear air is a preset.
inline constexpr double kMinVisibility = 5;  ///< metres
inline constexpr double kMaxVisibility = 50'000;

/// Approach categories by lowest runway visual range: ICAO Annex 6 as quoted by the AIP of India (AD 2.1, "Low
/// visibility procedures").
inline constexpr std::array<VisibilityPreset, 7> kVisibilityPresets{{
    {"CAT IIIB", 50, true, "Lowest runway visual range of category IIIB: 50 m"},
    {"CAT IIIA", 175, true, "Lowest runway visual range of category IIIA: 175 m"},
    {"CAT II", 300, true, "Lowest runway visual range of category II: 300 m"},
    {"CAT I", 550, true, "Lowest runway visual range of category I: 550 m"},
    {"Fog", 1000, false, "What reduces the visibility below 1 km is called fog"},
    {"10 km", 10'000, false, "The most that aviation reports"},
    {"Clear", std::numeric_limits<double>::infinity(), false, "No fog"},
}};

}  // namespace litfog::window
