// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

namespace litfog {

/// The illuminance at the eye at which a light is just visible, for a named background.
struct VisualThreshold {
  std::string_view name;
  double illuminance;  ///< lux
  std::string_view source;
};

inline constexpr double kNightThreshold = 8e-7;  ///< lux, a pilot's by night

/// The pilot's thresholds are those in use for runway visual range. They are quoted at second hand, not checked against
/// the Annex's text.
inline constexpr std::array<VisualThreshold, 5> kVisualThresholds{{
    {"dark night", 2e-7, "what a mariner sees by night, 33 CFR 84.14"},
    {"night", kNightThreshold, "what a pilot sees by night, commonly given after ICAO Annex 3, attachment D"},
    {"twilight", 1e-5, "what a pilot sees in twilight, commonly given after ICAO Annex 3, attachment D"},
    {"day", 1e-4, "what a pilot sees by day, commonly given after ICAO Annex 3, attachment D"},
    {"bright day", 1e-3, "what a pilot sees on a bright day, commonly given after ICAO Annex 3, attachment D"},
}};

inline constexpr double kMaxBackground = 1e12;  ///< cd/m2; the sun's disc has 2e9

/// The illuminance in lux at which a point of light is just visible against a background. With B the background's
/// luminance in cd/m2,
///   log10 E = 0.57 log10 B + 0.05 (log10 B)^2 - 6.66
/// (ICAO Doc 9328, "Manual of Runway Visual Range Observing and Reporting Practices"; quoted at second hand, not
/// checked at its source). It passes midway between the pilot's steps above at 50, 1000 and 12,000 cd/m2, where these
/// are commonly said to change. It falls with B down to 2e-6 cd/m2, and is taken as constant below.
///
/// background  cd/m2, [0, kMaxBackground]
double illuminance_threshold(double background);

}  // namespace litfog
