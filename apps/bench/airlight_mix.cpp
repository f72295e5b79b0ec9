// SPDX-License-Identifier: Apache-2.0
#include "bench/airlight_mix.h"

namespace litfog::bench {
namespace {

test::AirlightCase draw_any_case(test::Random& random, FogMode mode, LampLeg lamp_leg) {
  test::AirlightCase c = random.chance(1.0 / 3) ? test::draw_airlight_case(random, mode, lamp_leg)
                                                : test::draw_spot_airlight_case(random, mode, lamp_leg);
  if (random.chance(0.5)) c.scattering.asymmetry = random.uniform(-0.9, 0.9);
  return c;
}

test::AirlightCase draw_inverse_square_case(test::Random& random, FogMode mode, LampLeg lamp_leg) {
  test::AirlightCase c;
  c.scattering.lamp_leg = lamp_leg;
  const double knee = random.log_uniform(0.1, 10);
  c.light.light.attenuation = {0, 0, 1 / (knee * knee)};
  c.light.light.threshold = 1e-6;
  c.fog = Fog::from_visibility(mode, random.log_uniform(3, 1e5));
  const double offset = knee * random.log_uniform(1.001, 100);
  const double approach = (random.chance(0.25) ? -1 : 1) * knee * random.log_uniform(0.1, 300);
  c.ray.direction = test::draw_direction(random);
  c.light.position = approach * c.ray.direction + offset * test::draw_perpendicular(random, c.ray.direction);
  if (random.chance(0.5)) c.ray.length = knee * random.log_uniform(0.1, 1000);
  return c;
}

}  // namespace

const char* name_of(AirlightMix mix) {
  switch (mix) {
    case AirlightMix::point:
      return "point";
    case AirlightMix::any:
      return "any";
    case AirlightMix::inverse_square:
      break;
  }
  return "inverse-square";
}

std::vector<test::AirlightCase> draw_airlight_mix(AirlightMix mix, FogMode mode, LampLeg lamp_leg, std::size_t count,
                                                  std::uint64_t seed) {
  test::Random random(seed);
  std::vector<test::AirlightCase> rays;
  while (rays.size() < count) {
    const test::AirlightCase c = mix == AirlightMix::point ? test::draw_airlight_case(random, mode, lamp_leg)
                                 : mix == AirlightMix::any ? draw_any_case(random, mode, lamp_leg)
                                                           : draw_inverse_square_case(random, mode, lamp_leg);
    if (reference_airlight(c.light, c.fog, c.ray, c.scattering) > kDimAirlight) rays.push_back(c);
  }
  return rays;
}

}  // namespace litfog::bench
