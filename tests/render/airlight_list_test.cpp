// SPDX-License-Identifier: Apache-2.0
#include "render/airlight/airlight_list.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

#include "reference/random_airlight.h"
#include "render/light/hidden_range.h"

namespace litfog::test {
using namespace render;

namespace {

constexpr double kPixelsPerRadian = 800;
constexpr double kExposure = 2;

AirlightList list(const PlacedLight& light, const Atmosphere& atmosphere, const glm::dvec3& eye) {
  scene::Scene scene;
  scene.lights = {light};
  const SceneLights lights(scene, {.path = &lighting_paths().front(), .fog_lighting = FogLighting::airlight});
  return list_airlight(lights, atmosphere, eye, kPixelsPerRadian, kExposure);
}

PlacedLight lamp(const glm::dvec3& position) {
  return {.light = {.name = "lamp", .attenuation = {1, 0, 0.01}, .threshold = 0.001, .cone = {}}, .position = position};
}

/// Range at which a ray passes a light.
double passing_range(const PlacedLight& light, const EyeRay& ray) {
  const glm::dvec3 to_light = light.position - ray.origin;
  return glm::length(to_light - std::max(glm::dot(to_light, ray.direction), 0.0) * ray.direction);
}

TEST(AirlightList, LightsThatTheFogHidesAreLeftOut) {
  for (const FogMode mode : {FogMode::exp, FogMode::exp2}) {
    const Fog fog{mode, 0.1};
    EXPECT_EQ(list(lamp({0, 0, -20}), {fog}, {}).entries.size(), 1u);
    EXPECT_TRUE(list(lamp({0, 0, -400}), {fog}, {}).entries.empty());
    EXPECT_TRUE(list(lamp({0, 0, -20}), {{mode, 0}}, {}).entries.empty()) << "clear air";
  }
}

TEST(AirlightList, RayBeyondTheReachShowsLessThanTheBudget) {
  const double budget = kAirlightShare * visible_step(kExposure);
  Random random(11);
  int listed = 0;
  int beyond = 0;
  for (int i = 0; i < 1500; ++i) {
    const FogMode mode = random.pick(std::array{FogMode::exp, FogMode::exp2});
    AirlightCase c = draw_airlight_case(random, mode, LampLeg::fogged);
    Light& light = c.light.light;
    light.color = glm::dvec3(random.log_uniform(0.01, 100));
    c.atmosphere.phase = draw_phase(random);
    if (mode == FogMode::exp && random.chance(0.5)) draw_layers(random, c);
    const AirlightList found = list(c.light, c.atmosphere, c.ray.origin);
    const double reach = found.entries.empty() ? 0 : double(found.entries.front().reach);
    listed += int(found.entries.size());
    light = drawn_light(light, {.fog_lighting = FogLighting::airlight});
    c.ray.length = std::numeric_limits<double>::infinity();
    for (int ray = 0; ray < 5; ++ray) {
      c.ray.direction = draw_direction(random);
      if (!(passing_range(c.light, c.ray) > reach * (1 + 1e-6))) continue;
      ++beyond;
      EXPECT_LE(kAirlightUnit * light.color.r * reference_airlight(c.light, c.atmosphere, c.ray, c.lamp_leg),
                budget * (1 + 1e-9))
          << to_string(c) << ", reach " << reach;
    }
  }
  EXPECT_GT(listed, 300);
  EXPECT_GT(beyond, 500);
}

TEST(AirlightList, RayShowsLessThanItsShareOfAllLightsThatItLacks) {
  Random random(12);
  const auto ahead = [](Random& from) { return glm::normalize(glm::dvec3(0, 0, -1) + 0.3 * draw_direction(from)); };
  const Fog fog{FogMode::exp, 0.02};
  scene::Scene scene;
  for (int i = 0; i < 300; ++i) {
    PlacedLight light = lamp(ahead(random) * random.uniform(300, 1200));
    light.light.color = glm::dvec3(random.log_uniform(0.1, 10));
    scene.lights.push_back(light);
  }
  const RenderSettings settings{.fog_lighting = FogLighting::airlight};
  const SceneLights lights(scene, settings);
  for (const double exposure : {-6.0, 0.0, 6.0}) {
    const AirlightList found = list_airlight(lights, {fog}, {}, kPixelsPerRadian, exposure);
    std::vector<double> reaches(scene.lights.size(), 0.0);
    for (const AirlightEntry& entry : found.entries) reaches[std::size_t(entry.light)] = double(entry.reach);
    double worst = 0;
    for (int ray = 0; ray < 20; ++ray) {
      const EyeRay seen{.origin = {}, .direction = ahead(random)};
      double lacking = 0;
      for (std::size_t i = 0; i < reaches.size(); ++i) {
        const PlacedLight& light = lights.lights()[i];
        if (!(passing_range(light, seen) > reaches[i])) continue;
        lacking += kAirlightUnit * light.light.color.r * reference_airlight(light, {fog}, seen);
      }
      worst = std::max(worst, lacking / visible_step(exposure));
    }
    std::printf("lights that rays lack at %g EV: %.3f steps\n", exposure, worst);
    EXPECT_LE(worst, kAirlightShare) << exposure;
    EXPECT_GT(worst, 0) << exposure;
  }
}

TEST(SceneLights, RadialPathsKeepTheLightsOwnExtentByAirlight) {
  scene::Scene scene;
  scene.lights = {lamp({0, 0, -20})};
  scene.lights[0].light.threshold = 0.05;
  const double own = compute_extent(scene.lights[0].light.attenuation, scene.lights[0].light.threshold);
  for (const LightingPath& path : lighting_paths()) {
    const SceneLights by_airlight(scene, {.path = &path, .fog_lighting = FogLighting::airlight});
    if (path.range == RangeLaw::radial) {
      EXPECT_EQ(by_airlight.extents()[0], own) << path.name;
    } else {
      EXPECT_GT(by_airlight.extents()[0], own) << path.name;
    }
  }
}

TEST(AirlightList, LightsOfAProfileLieTogether) {
  scene::Scene scene;
  scene.lights = {lamp({0, 0, -20}), lamp({1, 0, -20}), lamp({2, 0, -20})};
  scene.lights[1].light.cone = Cone::smoothstep(0.1, 0.2);
  const SceneLights lights(scene, {.path = &lighting_paths().front(), .fog_lighting = FogLighting::airlight});
  const AirlightList found = list_airlight(lights, {{FogMode::exp, 0.01}}, {}, kPixelsPerRadian, kExposure);
  ASSERT_EQ(found.ranges.size(), 2u);
  EXPECT_EQ(found.ranges[0].kind.profile, 0);
  EXPECT_EQ(found.ranges[0].count, 2u);
  EXPECT_EQ(found.ranges[1].kind.profile, 2);
  EXPECT_EQ(found.ranges[1].first, 2u);
  EXPECT_EQ(found.entries[2].light, 1);
}

TEST(AirlightList, LightsAtTheEyeAndWithoutAnEndHaveFiniteNumbers) {
  PlacedLight endless = lamp({0, 0, -20});
  endless.light.attenuation = {2, 0, 0};
  for (const PlacedLight& light : {lamp({0, 0, 0}), endless}) {
    const AirlightList found = list(light, {{FogMode::exp, 0.01}}, {});
    ASSERT_EQ(found.entries.size(), 1u);
    const AirlightEntry& entry = found.entries.front();
    EXPECT_LE(entry.reach, 1e9f);
    EXPECT_TRUE(std::isfinite(entry.bend_range) && std::isfinite(entry.width));
  }
}

}  // namespace
}  // namespace litfog::test
