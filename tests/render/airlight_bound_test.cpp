// SPDX-License-Identifier: Apache-2.0
#include "render/airlight/airlight_bound.h"

#include <gtest/gtest.h>

#include <cmath>

#include "reference/double_limits.h"
#include "reference/random_airlight.h"

namespace litfog::test {
using namespace render;

namespace {

TEST(RenderAirlightBound, NoMoreThanTheBudgetComesFromBehindTheEnd) {
  Random random(25);
  int attacked = 0;
  for (int i = 0; i < 2000; ++i) {
    AirlightCase c = draw_airlight_case(random, random.pick(kModes), LampLeg::fogged);
    c.atmosphere.phase = draw_phase(random);
    if (c.atmosphere.fog.mode == FogMode::exp && random.chance(0.5)) draw_layers(random, c);
    Light& light = c.light.light;
    light.color = glm::dvec3(random.log_uniform(0.01, 100));
    const double budget = random.log_uniform(1e-8, 1e-3);
    const glm::dvec3 to_light = c.light.position - c.ray.origin;
    const ScatteringBound scattering(c.atmosphere.phase);
    const AirlightBound bound(c.light, compute_extent(light.attenuation, light.threshold), c.atmosphere, scattering,
                              c.ray.origin);
    const double end = bound.end(budget);
    if (std::isinf(end)) continue;
    if (glm::length(to_light) > 0 && random.chance(0.5)) {  // close to the light, where it is brightest
      c.ray.direction = glm::normalize(glm::normalize(to_light) + 0.05 * draw_direction(random));
    }
    c.ray.length = kInfinity;
    const double whole = reference_airlight(c.light, c.atmosphere, c.ray, c.lamp_leg);
    c.ray.length = end * random.uniform(1, 1.2);
    const double before = reference_airlight(c.light, c.atmosphere, c.ray, c.lamp_leg);
    const double shown = kAirlightUnit * light.color.r;
    EXPECT_LE(shown * (whole - before), budget + 1e-9 * shown * whole) << to_string(c) << ", " << end;
    attacked += shown * whole > budget;
  }
  EXPECT_GT(attacked, 500);
}

}  // namespace
}  // namespace litfog::test
