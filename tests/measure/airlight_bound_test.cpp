// SPDX-License-Identifier: Apache-2.0
#include "measure/reference_light.h"

#include <gtest/gtest.h>

#include <cstdio>

#include "litfog/attenuation.h"
#include "reference/double_limits.h"
#include "reference/random_airlight.h"

namespace litfog::test {
namespace {

measure::ReferenceLight reference_light(const PlacedLight& light) {
  return {.placed = light,
          .extent = compute_extent(light.light.attenuation, light.light.threshold),
          .fog_threshold = light.light.threshold,
          .fog_extent = compute_extent(light.light.attenuation, light.light.threshold),
          .fog_intensity = 0,
          .cookie = nullptr,
          .cookie_from_world = glm::dmat3(1.0)};
}

TEST(MeasureAirlightBound, BoundIsNeverBelowTheAirlight) {
  constexpr double kQuadrature = 1e-9;  // ten times what the reference states
  constexpr double kRounding = 1e-15;   // for rays through the lamp, whose side is rounding
  Random random(91);
  int useful = 0;
  for (int i = 0; i < 4000; ++i) {
    const FogMode mode = random.pick(kModes);
    AirlightCase c = random.chance(0.5) ? draw_airlight_case(random, mode, LampLeg::fogged)
                                        : draw_spot_airlight_case(random, mode, LampLeg::fogged);
    c.atmosphere.phase = draw_phase(random);
    const double bound = measure::airlight_bound(reference_light(c.light), c.ray, c.atmosphere);
    const double airlight = reference_airlight(c.light, c.atmosphere, c.ray, c.lamp_leg);
    ASSERT_GE(bound + kRounding, airlight * (1 - kQuadrature)) << to_string(c);
    if (bound < 1 / 255.) ++useful;
  }
  std::printf("%d of 4000 rays are found to show less than 1/255\n", useful);
  EXPECT_GT(useful, 400);
}

}  // namespace
}  // namespace litfog::test
