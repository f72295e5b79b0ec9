// SPDX-License-Identifier: Apache-2.0
#include "bench/airlight_mix.h"

namespace litfog::bench {
namespace {

test::AirlightCase draw_any_case(test::Random& random, FogMode mode, LampLeg lamp_leg) {
  test::AirlightCase c = random.chance(1.0 / 3) ? test::draw_airlight_case(random, mode, lamp_leg)
                                                : test::draw_spot_airlight_case(random, mode, lamp_leg);
  if (random.chance(0.5)) c.atmosphere.phase = Phase::henyey_greenstein(random.uniform(-0.9, 0.9));
  return c;
}

test::AirlightCase draw_case(AirlightMix mix, test::Random& random, FogMode mode, LampLeg lamp_leg) {
  switch (mix) {
    case AirlightMix::point:
      return test::draw_airlight_case(random, mode, lamp_leg);
    case AirlightMix::ahead:
    case AirlightMix::droplets:
    case AirlightMix::layers: {
      test::AirlightCase c = test::draw_airlight_case(random, mode, lamp_leg);
      if (mix == AirlightMix::ahead) c.atmosphere.phase = Phase::henyey_greenstein(0.85);
      if (mix == AirlightMix::droplets) c.atmosphere.phase = Phase::droplets(10);
      if (mix == AirlightMix::layers) test::draw_layers(random, c);
      return c;
    }
    case AirlightMix::any:
      return draw_any_case(random, mode, lamp_leg);
    case AirlightMix::inverse_square:
      break;
  }
  return test::draw_inverse_square_airlight_case(random, mode, lamp_leg);
}

}  // namespace

const char* name_of(AirlightMix mix) {
  constexpr const char* kNames[] = {"point", "g-0.85", "droplets", "layers", "any", "inverse-square"};
  return kNames[int(mix)];
}

std::vector<test::AirlightCase> draw_airlight_mix(AirlightMix mix, FogMode mode, LampLeg lamp_leg, std::size_t count,
                                                  std::uint64_t seed) {
  test::Random random(seed);
  std::vector<test::AirlightCase> rays;
  while (rays.size() < count) {
    const test::AirlightCase c = draw_case(mix, random, mode, lamp_leg);
    if (reference_airlight(c.light, c.atmosphere, c.ray, c.lamp_leg) > kDimAirlight) rays.push_back(c);
  }
  return rays;
}

}  // namespace litfog::bench
