// SPDX-License-Identifier: Apache-2.0
#include "render/airlight/far_airlight_list.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <limits>
#include <vector>

#include "litfog/attenuation.h"
#include "reference/random_airlight.h"
#include "render/light/hidden_range.h"
#include "render/plan/fog_top.h"

namespace litfog::test {
using namespace render;

namespace {

const RenderSettings kByAirlight{.fog_lighting = FogLighting::airlight};

/// What a light adds beyond its extent to a ray from a distance from its origin on.
double far_airlight(PlacedLight light, const Atmosphere& atmosphere, EyeRay ray, double from) {
  const double end = light.light.threshold;
  const auto within = [&](double threshold, double length) {
    light.light.threshold = threshold;
    ray.length = length;
    return reference_airlight(light, atmosphere, ray);
  };
  constexpr double kWhole = std::numeric_limits<double>::infinity();
  constexpr double kEndless = 1e-12;
  return (within(kEndless, kWhole) - within(end, kWhole)) - (within(kEndless, from) - within(end, from));
}

/// How far from the eye a listed light is drawn.
double end_of(const FarAirlightList& list, std::int32_t light) {
  const auto place = int(std::ranges::find(list.lights, light) - list.lights.begin());
  const auto range = std::ranges::find_if(list.ranges, [&](const FarAirlightList::Range& each) {
    return place >= each.first && place < each.first + each.counts[0];
  });
  const auto sections = std::ranges::count_if(range->counts, [&](int count) { return place < range->first + count; });
  return list.section_begin(int(sections));
}

TEST(FarAirlightList, RayShowsNoMoreThanAThirdOfTheShareOfALightThatIsLeftOutOrBeyondItsEnd) {
  constexpr double kExposure = 1;
  const double budget = kFarShare / 3 * visible_step(kExposure);
  Random random(31);
  int listed = 0;
  int left_out = 0;
  double most = 0;
  for (int i = 0; i < 600; ++i) {
    const FogMode mode = random.pick(kModes);
    AirlightCase c = random.chance(0.5) ? draw_airlight_case(random, mode, LampLeg::fogged)
                                        : draw_spot_airlight_case(random, mode, LampLeg::fogged);
    c.light.light.color = glm::dvec3(random.log_uniform(0.01, 100));
    // Of lobes ahead, the sum has no peak (litfog/shaders/far_airlight.glsl).
    c.atmosphere.phase = random.chance(0.5) ? Phase{} : Phase::henyey_greenstein(-random.uniform(0, 0.9));
    scene::Scene scene;
    scene.lights = {c.light};
    const SceneLights lights(scene, kByAirlight);
    if (lights.size() == 0) continue;
    const FarAirlightList list = list_far_airlight(lights, c.atmosphere, c.ray.origin, kExposure);
    ++(list.lights.empty() ? left_out : listed);
    const double end = list.lights.empty() ? 0 : end_of(list, 0);
    if (end >= double(kSkyDistance)) continue;
    const PlacedLight& light = lights.lights()[0];
    const double beyond = kAirlightUnit * light.light.color.r * far_airlight(light, c.atmosphere, c.ray, end);
    EXPECT_LE(beyond, budget * (1 + 1e-6)) << to_string(c) << ", end " << end;
    most = std::max(most, beyond / budget);
  }
  std::printf("%d lights listed, %d left out; at most %.2f of the budget\n", listed, left_out, most);
  EXPECT_GT(listed, 100);
  EXPECT_GT(left_out, 100);
  EXPECT_GT(most, 0.01);
}

TEST(FarAirlightList, RayShowsNoMoreThanItsShareOfAllThatIsLeftOutOfManyLights) {
  Random random(32);
  const Fog fog{FogMode::exp, 0.004};
  scene::Scene scene;
  const auto ahead = [&] { return glm::normalize(glm::dvec3(0, 0, -1) + 0.3 * draw_direction(random)); };
  for (int i = 0; i < 300; ++i) {
    PlacedLight light;
    light.light.attenuation = {1, 0, random.log_uniform(0.001, 10)};
    light.light.color = glm::dvec3(random.log_uniform(0.1, 10));
    light.position = ahead() * random.uniform(50, 1500);
    scene.lights.push_back(light);
  }
  const SceneLights lights(scene, kByAirlight);
  const FarAirlightList list = list_far_airlight(lights, {fog}, {}, 0);
  ASSERT_GT(list.lights.size(), 50u);
  ASSERT_LT(list.lights.size(), 300u);
  const auto is_cut = [&](std::int32_t light) { return end_of(list, light) < list.depth; };
  EXPECT_GT(std::ranges::count_if(list.lights, is_cut), 50);
  ASSERT_LT(list.depth, double(kSkyDistance));
  double worst = 0;
  for (int i = 0; i < 5; ++i) {
    const EyeRay ray{.origin = {}, .direction = ahead()};
    double lacking = 0;
    for (std::size_t light = 0; light < lights.size(); ++light) {
      const bool is_listed = std::ranges::find(list.lights, std::int32_t(light)) != list.lights.end();
      lacking += kAirlightUnit * lights.lights()[light].light.color.r *
                 far_airlight(lights.lights()[light], {fog}, ray, is_listed ? end_of(list, std::int32_t(light)) : 0);
    }
    worst = std::max(worst, lacking / visible_step(0));
  }
  std::printf("%zu of 300 lights listed, rays lack %.4f steps\n", list.lights.size(), worst);
  EXPECT_LE(worst, kFarShare);
  EXPECT_GT(worst, 0);
}

TEST(FarAirlightList, LightIsListedThatMattersOnlyToRaysThatTouchItsExtent) {
  PlacedLight light;
  light.light.attenuation = {1, 0, 1};
  light.light.threshold = 1e-4;
  const double extent = compute_extent(light.light.attenuation, light.light.threshold);
  light.position = {extent, 0, -20 * extent};
  const Fog fog{FogMode::exp, 5e-3 / extent};
  const EyeRay touching{.origin = {}, .direction = {0, 0, -1}};
  const double beyond = far_airlight(light, {fog}, touching, 0);
  const double inward = 2 * fog.density / extent;  // of a ray through the light: 2 times the integral of 1 / r^2
  EXPECT_GT(beyond, 1.3 * inward);
  light.light.color = glm::dvec3(1.05 * kFarShare / 3 * visible_step(0) / (kAirlightUnit * beyond));
  scene::Scene scene;
  scene.lights = {light};
  EXPECT_EQ(list_far_airlight(SceneLights(scene, kByAirlight), {fog}, {}, 0).lights.size(), 1u);
}

TEST(FarAirlightList, NothingIsListedInClearAirAndInTotalFogOrOfLightsThatCutShaftsOrHaveNoEnd) {
  scene::Scene scene;
  PlacedLight light;
  light.light.attenuation = {1, 0, 0.001};
  light.position = {0, 0, -100};
  scene.lights = {light};
  const SceneLights lights(scene, kByAirlight);
  const Fog fog{FogMode::exp, 0.001};
  const std::vector<std::int32_t> casters{0};
  ASSERT_EQ(list_far_airlight(lights, {fog}, {}, 0).lights.size(), 1u);
  EXPECT_EQ(list_far_airlight(lights, {fog}, {}, 0, {}, casters).depth, 0);
  EXPECT_EQ(list_far_airlight(lights, {{FogMode::exp, 0}}, {}, 0).depth, 0);
  EXPECT_EQ(list_far_airlight(lights, {{FogMode::exp, kInfinity}}, {}, 0).depth, 0);
  scene.lights[0].light.attenuation = {2, 0, 0};
  EXPECT_EQ(list_far_airlight(SceneLights(scene, kByAirlight), {fog}, {}, 0).depth, 0);
}

}  // namespace
}  // namespace litfog::test
