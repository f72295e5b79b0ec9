// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "reference/random_airlight.h"

namespace litfog::bench {

/// What lamps and rays a benchmark of the airlight is over.
enum class AirlightMix {
  /// Point lamps in isotropic fog, as test::draw_airlight_case draws them: C = 0, below, at and above 1, L and Q 0 in a
  /// quarter each and else log-uniform over decades, threshold 0.05 in half; visibility 3 m to 100 km log-uniform, in
  /// one of twenty 5 cm to 3 m; rays through, past, from and behind the lamp, of any length.
  point,
  /// The lamps and rays of `point` in fog by Henyey and Greenstein's phase function with g = 0.85.
  ahead,
  /// The lamps and rays of `point` in fog of droplets of 10 micrometres.
  droplets,
  /// The lamps and rays of `point` in isotropic fog of one or two layers, as test::draw_layers() places them.
  layers,
  /// All parameters: a third of the lamps of `point`, two thirds spots of 0.1 to 180 degrees of both profiles, two
  /// thirds of them aimed near the ray; half of the rays in fog that scatters by g uniform in (-0.9, 0.9).
  any,
  /// What tables and arctangents know: C = L = 0, Q of a knee of 0.1 to 10 m, rays that stay outside of the knee, the
  /// extent a thousand knees; visibility 3 m to 100 km.
  inverse_square
};

const char* name_of(AirlightMix mix);

/// Rays whose airlight is more than kDimAirlight. A seed gives the same rays everywhere.
std::vector<test::AirlightCase> draw_airlight_mix(AirlightMix mix, FogMode mode, LampLeg lamp_leg, std::size_t count,
                                                  std::uint64_t seed);

}  // namespace litfog::bench
