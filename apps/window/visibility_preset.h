// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <limits>

namespace litfog::window {

/// A visibility that has a name.
struct VisibilityPreset {
  const char* name;
  double metres;
  const char* meaning;  ///< one sentence
};

// The slider's ends. Clear air is a preset.
inline constexpr double kMinVisibility = 5;  ///< metres
inline constexpr double kMaxVisibility = 50'000;

/// Approach categories by their lowest runway visual range: ICAO Annex 6 as the AIP of India quotes it (AD 2.1, "Low
/// visibility procedures"). That is how far lamps are seen, and is taken for the visibility, whatever contrast that
/// means.
inline constexpr std::array<VisibilityPreset, 7> kVisibilityPresets{{
    {"CAT IIIB", 50, "Lowest runway visual range of category IIIB: 50 m"},
    {"CAT IIIA", 175, "Lowest runway visual range of category IIIA: 175 m"},
    {"CAT II", 300, "Lowest runway visual range of category II: 300 m"},
    {"CAT I", 550, "Lowest runway visual range of category I: 550 m"},
    {"Fog", 1000, "What reduces the visibility below 1 km is called fog"},
    {"10 km", 10'000, "The most that aviation reports"},
    {"Clear", std::numeric_limits<double>::infinity(), "No fog"},
}};

}  // namespace litfog::window
