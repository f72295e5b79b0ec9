// SPDX-License-Identifier: Apache-2.0
#include "bench/airlight_rival.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "bench/airlight_mix.h"

namespace litfog::bench {
namespace {

std::vector<test::AirlightCase> rays_of(AirlightMix mix) {
  return draw_airlight_mix(mix, FogMode::exp, LampLeg::fogged, 500, 20'090'401);
}

TEST(AirlightRival, PegorarosClosedFormIsTheReference) {
  for (const test::AirlightCase& c : rays_of(AirlightMix::inverse_square)) {
    const double reference = reference_airlight(c.light, c.atmosphere, c.ray, c.lamp_leg);
    EXPECT_NEAR(pegoraro_airlight(c) / reference, 1, 1e-9) << to_string(c);
  }
}

// Where layers begin or end within a step, or rays are lit beyond the march's far plane, a march misses some.
TEST(AirlightRival, LongMarchThroughLayersIsTheReferenceInMostRays) {
  const std::vector<test::AirlightCase> rays = rays_of(AirlightMix::layers);
  const auto count = std::ranges::count_if(rays, [](const test::AirlightCase& c) {
    const double reference = reference_airlight(c.light, c.atmosphere, c.ray, c.lamp_leg);
    return std::abs(march_lit_airlight(c, 20'000) - reference) <= 1e-3 * std::max(reference, 0.01);
  });
  EXPECT_GE(count, 0.98 * double(rays.size()));
}

}  // namespace
}  // namespace litfog::bench
