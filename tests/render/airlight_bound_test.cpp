// SPDX-License-Identifier: Apache-2.0
#include "render/airlight/airlight_bound.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

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

// Rays that pass the light so far away that they have no peak.
TEST(RenderAirlightBound, HigherOrdersAreNoMoreThanTheirBound) {
  Random random(26);
  double most = 0;
  int attacked = 0;
  for (int i = 0; i < 2000; ++i) {
    const Phase phase = i % 2 == 0 ? Phase{} : Phase::droplets(10);
    Atmosphere air{.fog = {FogMode::exp, 1}, .phase = phase};
    const ScatteringTable table = make_scattering_table(air);
    const double thickness = random.log_uniform(0.1, 10);
    if (i % 4 >= 2) {
      air.fog.density = random.chance(0.5) ? 0 : random.log_uniform(1e-4, 0.1);
      air.profile = make_density_profile(
          std::array<DensityKnot, 4>{{{-0.01, 0}, {0, 1}, {thickness, 1}, {1.2 * thickness, 0}}});
    }
    PlacedLight light;
    light.position = {random.log_uniform(0.1, 6), random.uniform(-0.2, 1.4) * thickness, 0};
    light.light.attenuation = {.constant = 0, .linear = 0, .quadratic = 1e4};
    if (i % 3 == 0) light.light.attenuation = {.constant = 1, .linear = 0, .quadratic = random.log_uniform(0.01, 100)};
    light.light.color = glm::dvec3(1);
    EyeRay ray{.origin = {0, random.uniform(-0.2, 1.4) * thickness, 0}};
    const ScatteringBound scattering(phase);
    const ScatteringSource source = scattering_source(light.light, air);
    const PointGlow glow{&table, source.intensity, source.soft_range};
    const AirlightBound bound(light, 100, air, scattering, ray.origin, glow);
    const double near = bound.higher_orders_reach(1e-300);
    do ray.direction = draw_direction(random);
    while (glm::length(glm::cross(ray.direction, light.position - ray.origin)) < near &&
           glm::dot(ray.direction, light.position - ray.origin) > 0);
    const double whole = multiple_scattering(light, air, table, ray);
    const double distance = random.chance(0.3) ? 0 : random.log_uniform(0.05, 20);
    ray.length = distance;
    const double beyond = airlight_unit(air) * (whole - multiple_scattering(light, air, table, ray));
    const double bounded = bound.higher_orders(distance);
    EXPECT_LE(beyond, bounded * 1.001 + 1e-3 * airlight_unit(air) * whole) << i << ": " << distance << ", " << thickness ;
    most = std::max(most, beyond / bounded);
    attacked += beyond > 0;
  }
  std::printf("at most %.3f of the bound\n", most);
  EXPECT_GT(attacked, 500);
}

TEST(RenderAirlightBound, LightInTheEyeGlowsInLayers) {
  Atmosphere air{.fog = {FogMode::exp, 1}};
  const ScatteringTable table = make_scattering_table(air);
  air.fog.density = 0;
  air.profile = make_density_profile(std::array<DensityKnot, 4>{{{-1, 0}, {0, 1}, {3, 1}, {4, 0}}});
  PlacedLight light;
  light.position = {2, 1, -3};
  const ScatteringBound scattering(air.phase);
  const AirlightBound bound(light, 100, air, scattering, light.position, {&table, source_intensity(light.light, air)});
  const double seen =
      airlight_unit(air) * multiple_scattering(light, air, table, {.origin = light.position, .direction = {1, 0, 0}});
  EXPECT_GT(seen, 0);
  EXPECT_LE(seen, bound.higher_orders(0));
  EXPECT_TRUE(std::isfinite(bound.higher_orders(0)));
}

}  // namespace
}  // namespace litfog::test
