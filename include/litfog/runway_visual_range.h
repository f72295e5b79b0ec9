// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "litfog/fog.h"
#include "litfog/value_error.h"
#include "litfog/visual_threshold.h"

namespace litfog {

/// What a runway visual range depends on besides the fog: the lamps along the runway, and the eye that looks for them.
struct RunwayLights {
  double candela =
      10'000;  ///< a lamp's intensity, finite, >= 0; 0: markings alone are seen. Edge lights: CS ADR-DSN.U.940
  double illuminance_threshold = kNightThreshold;  ///< lux, finite, > 0: the least that is seen (visual_threshold.h)

  friend bool operator==(const RunwayLights&, const RunwayLights&) = default;
};

/// What is wrong with runway lights, or nothing.
std::optional<ValueError> find_error(const RunwayLights& lights);

/// What is wrong with a runway visual range that lamps, which must pass find_error(), are to have, or nothing.
std::optional<ValueError> find_runway_visual_range_error(double metres, const RunwayLights& lights);

/// Largest errors of the density and of the way there and back, both relative.
inline constexpr double kRunwayDensityMaxError = 1e-13;
inline constexpr double kRunwayRoundTripMaxError = 1e-13;

/// The fog of a runway visual range R, which is not its visibility: at night, lamps of 10,000 cd are seen for 550 m in
/// fog whose meteorological optical range is 155 m. R is how far either lamps or markings are seen, whichever is
/// farther. With I in candela, E the threshold in lux and f the fog factor,
///   lamps     I f(R) / R^2 = E         Allard 1876
///   markings  f(R) = kContrastMor      Koschmieder 1924, with the contrast of ICAO
/// (as in ICAO Doc 9328, quoted at second hand, not checked at its source). The fog is the denser of the two. Both are
/// stated for `exp` fog; in `exp2` fog they hold with its own f.
///
/// metres     R >= 0; 0 is total fog, infinity clear air. A finite R must not exceed sqrt(I / E), where the lamps are
///            last seen in clear air, unless I is 0.
/// max error  kRunwayDensityMaxError                                            (runway_visual_range_test.cpp)
/// throws     std::invalid_argument naming field, value and rule
Fog fog_from_runway_visual_range(FogMode mode, double metres, const RunwayLights& lights = {});

/// The runway visual range of a fog, the inverse of fog_from_runway_visual_range. Fog so thin that markings are seen
/// farther than the lamps are in clear air has the markings' range.
///
/// returns    metres; 0 in total fog, infinity in clear air
/// max error  kRunwayRoundTripMaxError there and back                           (runway_visual_range_test.cpp)
/// throws     std::invalid_argument naming field, value and rule
double runway_visual_range(const Fog& fog, const RunwayLights& lights = {});

}  // namespace litfog
