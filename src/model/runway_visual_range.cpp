// SPDX-License-Identifier: Apache-2.0
#include "litfog/runway_visual_range.h"

#include <algorithm>
#include <cmath>

#include "float_limit.h"
#include "require.h"

namespace litfog {
namespace {

/// ln(I / E): quotients of extreme values leave the range of a double.
double log_brightness(const RunwayLights& lights) {
  return std::log(lights.candela) - std::log(lights.illuminance_threshold);
}

/// Optical depth at which markings are just seen.
double marking_depth() { return -std::log(kContrastMor); }

}  // namespace

std::optional<ValueError> find_error(const RunwayLights& lights) {
  if (!is_finite_and_not_negative(lights.candela)) {
    return ValueError{"candela", lights.candela, "must be finite and >= 0"};
  }
  if (!(lights.illuminance_threshold > 0) || std::isinf(lights.illuminance_threshold)) {
    return ValueError{"illuminance_threshold", lights.illuminance_threshold, "must be finite and > 0"};
  }
  return std::nullopt;
}

std::optional<ValueError> find_runway_visual_range_error(double metres, const RunwayLights& lights) {
  if (!(metres >= 0)) return ValueError{"runway_visual_range", metres, "must be >= 0"};
  const double reach = std::sqrt(lights.candela) / std::sqrt(lights.illuminance_threshold);
  if (lights.candela > 0 && std::isfinite(metres) && !is_within(metres, 0, reach)) {
    return ValueError{"runway_visual_range", metres,
                      "must be at most sqrt(candela / illuminance_threshold), where the lamps are last seen in clear "
                      "air"};
  }
  return std::nullopt;
}

Fog fog_from_runway_visual_range(FogMode mode, double metres, const RunwayLights& lights) {
  require(find_error(lights));
  require(find_runway_visual_range_error(metres, lights));
  metres = std::abs(metres);  // -0 is 0
  const double lamp_depth = log_brightness(lights) - 2 * std::log(metres);
  const double depth = std::max(marking_depth(), lamp_depth);  // the first where the second is NaN: 0 cd and 0 m
  return {mode, (mode == FogMode::exp ? depth : std::sqrt(depth)) / metres};
}

double runway_visual_range(const Fog& fog, const RunwayLights& lights) {
  require(find_error(fog));
  require(find_error(lights));
  if (std::isinf(fog.density)) return 0;
  const double density = std::abs(fog.density);
  // R is x / d in exp fog and sqrt(x) / d in exp2, by the depth x at R, so that Allard's law reads
  //   x + k ln x = ln(I / E) + 2 ln d    with k = 2 or 1.
  // Its left side rises ever more slowly, so that Newton's steps from below the root never pass it. They begin at the
  // markings' depth, where they end at once if the lamps are not seen so far.
  const double k = fog.mode == FogMode::exp ? 2 : 1;
  const double target = log_brightness(lights) + 2 * std::log(density);
  double depth = marking_depth();
  constexpr int kMaxSteps = 20;  // 5 are taken, then some by an ulp
  for (int step = 0; step < kMaxSteps; ++step) {
    const double next = depth + (target - depth - k * std::log(depth)) / (1 + k / depth);
    if (!(next > depth)) break;
    depth = next;
  }
  return (fog.mode == FogMode::exp ? depth : std::sqrt(depth)) / density;
}

}  // namespace litfog
