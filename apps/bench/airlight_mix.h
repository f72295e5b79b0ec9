// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "reference/random_airlight.h"

namespace litfog::bench {

/// The lamps and rays of an airlight benchmark.
enum class AirlightMix {
  /// Point lamps in isotropic fog, as test::draw_airlight_case draws them: C = 0, below, at and above 1, L and Q 0 in a
  /// quarter each and else log-uniform over decades, threshold 0.05 in half; visibility 3 m to 100 km log-uniform, in
  /// one of twenty 5 cm to 3 m; rays through, past, from and behind the lamp, of any length.
  point,
  /// The lamps and rays of `point` in fog with a Henyey-Greenstein phase function, g = 0.85.
  ahead,
  /// The lamps and rays of `point` in fog of droplets of 10 micrometres.
  droplets,
  /// The lamps and rays of `point` in isotropic fog of one or two layers, as test::draw_layers() places them.
  layers,
  /// All parameters: a third lamps as in `point`, two thirds spots of 0.1 to 180 degrees of both profiles, two thirds
  /// of them aimed near the ray; half of the rays in fog with g uniform in (-0.9, 0.9).
  any,
  /// The cases of tables and arctangents: C = L = 0, Q for a knee of 0.1 to 10 m, rays outside of the knee, an extent
  /// of a thousand knees; visibility 3 m to 100 km.
  inverse_square
};

const char* name_of(AirlightMix mix);

/// Rays with an airlight above kDimAirlight. A seed gives the same rays on every machine.
std::vector<test::AirlightCase> draw_airlight_mix(AirlightMix mix, FogMode mode, LampLeg lamp_leg, std::size_t count,
                                                  std::uint64_t seed);

}  // namespace litfog::bench
