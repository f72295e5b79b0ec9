// SPDX-License-Identifier: Apache-2.0
#include "litfog/fog_light_block.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "core/value_errors.h"
#include "reference/double_limits.h"

namespace litfog::test {
namespace {

constexpr float kLargestFloat = std::numeric_limits<float>::max();

/// Every field another value.
PlacedLight distinct_light() {
  return {.light = {.name = "distinct",
                    .color = {0.25, 0.5, 0.75},
                    .attenuation = {1.5, 0.125, 0.0625},
                    .threshold = 0.01,
                    .cone = Cone::cosine(0.5, 8),
                    .density_scale = 0.4},
          .position = {1, -2, 3},
          .direction = {0, 0.6, -0.8},
          .carried = true};
}

constexpr FogIntensity kSolution{.intensity = 0.375, .peak_range = 4, .extent = 40, .status = SolveStatus::ok};

TEST(FogLight, EveryFieldIsAtItsOffset) {
  const FogLight packed = pack_fog_light(distinct_light(), kSolution);
  EXPECT_EQ(packed.position_extent, glm::vec4(1, -2, 3, 40));
  EXPECT_EQ(packed.axis_profile, glm::vec4(0, 0.6f, -0.8f, 1));
  EXPECT_EQ(packed.color_intensity, glm::vec4(0.25, 0.5, 0.75, 0.375));
  EXPECT_EQ(packed.attenuation, glm::vec4(1.5, 0.125, 0.0625, 0.4f));
  EXPECT_EQ(packed.cone, glm::vec4(float(std::cos(0.5)), 8, 0, 0));
}

TEST(FogLight, ProfilesAreNumbered) {
  PlacedLight light = distinct_light();
  light.light.cone = Cone::smoothstep(0.25, 0.75);
  const FogLight dual = pack_fog_light(light, kSolution);
  EXPECT_EQ(dual.axis_profile.w, 2);
  EXPECT_EQ(dual.cone, glm::vec4(float(std::cos(0.75)), float(std::cos(0.25)), 0, 0));
  light.light.cone = Cone{};
  const FogLight point = pack_fog_light(light, kSolution);
  EXPECT_EQ(point.axis_profile.w, 0);
  EXPECT_EQ(point.cone, glm::vec4(0));
}

TEST(FogLight, OnlyACarriedLightLightsTheFog) {
  PlacedLight light = distinct_light();
  light.carried = false;
  EXPECT_EQ(pack_fog_light(light, kSolution).color_intensity, glm::vec4(0.25, 0.5, 0.75, 0));
}

TEST(FogLight, InfiniteAndOverlargeValuesBecomeTheLargestFloat) {
  PlacedLight light = distinct_light();
  light.light.attenuation = {1e300, 1e200, 1e100};
  const FogLight packed =
      pack_fog_light(light, {.intensity = 1, .peak_range = kInfinity, .extent = kInfinity, .status = SolveStatus::ok});
  EXPECT_EQ(packed.position_extent.w, kLargestFloat);
  EXPECT_EQ(packed.attenuation, glm::vec4(kLargestFloat, kLargestFloat, kLargestFloat, 0.4f));
  light.light.color = {1e300, 2, 1e39};
  light.light.density_scale = 1e300;
  const FogLight bright = pack_fog_light(light, {.intensity = 1, .peak_range = 0, .extent = 1, .status = {}});
  EXPECT_EQ(glm::vec3(bright.color_intensity), glm::vec3(kLargestFloat, 2, kLargestFloat));
  EXPECT_EQ(bright.attenuation.w, kLargestFloat);
  EXPECT_EQ(pack_fog_light(light, {.intensity = 1, .peak_range = 0, .extent = 1e39, .status = SolveStatus::ok})
                .position_extent.w,
            kLargestFloat);
}

TEST(FogLight, WronglyPlacedLightIsAnError) {
  const auto error_after = [](const auto& change) {
    PlacedLight light = distinct_light();
    change(light);
    return error_of([&] { pack_fog_light(light, kSolution); });
  };
  EXPECT_EQ(error_after([](PlacedLight& p) { p.position.z = 1e300; }),
            "position.z = 1e+300: must be at most 16777216 in magnitude");
  EXPECT_EQ(error_after([](PlacedLight& p) {
              p.direction = {0, 0, 0};
            }),
            "direction = 0: length must be 1 within 1e-6");
  EXPECT_EQ(error_after([](PlacedLight& p) { p.light.color.g = kNan; }), "color.g = nan: must be finite and >= 0");
}

TEST(FogLightBlock, WronglyPlacedLightIsAnError) {
  std::vector<PlacedLight> lights(2, distinct_light());
  lights[1].position.x = kNan;
  const std::vector<FogIntensity> solutions(2, kSolution);
  EXPECT_EQ(error_of([&] { pack_fog_light_block({}, {}, lights, solutions); }),
            "position.x = nan: must be at most 16777216 in magnitude");
}

TEST(FogLightBlock, AmbientFogColorThatIsNoLightIsAnError) {
  const auto error_with = [](const glm::dvec3& color) {
    return error_of([&] { pack_fog_light_block({}, color, {}, {}); });
  };
  EXPECT_EQ(error_with({kNan, 0, 0}), "ambient_fog_color.r = nan: must be finite and >= 0");
  EXPECT_EQ(error_with({0, -1, 0}), "ambient_fog_color.g = -1: must be finite and >= 0");
  EXPECT_EQ(error_with({0, 0, kInfinity}), "ambient_fog_color.b = inf: must be finite and >= 0");
}

TEST(FogLightBlock, BlockHoldsFogCountAndAmbientColor) {
  const std::vector<PlacedLight> lights(3, distinct_light());
  const std::vector<FogIntensity> solutions(3, kSolution);
  const FogLightBlock exp_block = pack_fog_light_block({FogMode::exp, 0.125}, {0.1, 0.2, 0.3}, lights, solutions);
  EXPECT_EQ(exp_block.fog, glm::vec4(0.125, 0, 3, 0));
  EXPECT_EQ(exp_block.ambient_fog_color, glm::vec4(0.1f, 0.2f, 0.3f, 0));
  const FogLightBlock exp2_block = pack_fog_light_block({FogMode::exp2, 0.25}, {0.1, 0.2, 0.3}, lights, solutions);
  EXPECT_EQ(exp2_block.fog, glm::vec4(0.25, 1, 3, 0));
}

TEST(FogLightBlock, LightsAreInOrderWithZerosBehindThem) {
  std::vector<PlacedLight> lights(3, distinct_light());
  std::vector<FogIntensity> solutions(3, kSolution);
  for (int i = 0; i < 3; ++i) {
    lights[std::size_t(i)].position.x = 10 * i;
    solutions[std::size_t(i)].intensity = 0.25 * i;
  }
  const FogLightBlock block = pack_fog_light_block({}, {}, lights, solutions);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(block.lights[std::size_t(i)].position_extent.x, float(10 * i));
    EXPECT_EQ(block.lights[std::size_t(i)].color_intensity.w, 0.25f * float(i));
  }
  const FogLight unused{};
  for (std::size_t i = 3; i < kMaxFogLights; ++i) {
    EXPECT_EQ(std::memcmp(&block.lights[i], &unused, sizeof unused), 0) << "light " << i;
  }
}

TEST(FogLightBlock, TotalFogBecomesTheLargestFloat) {
  EXPECT_EQ(pack_fog_light_block({FogMode::exp, kInfinity}, {}, {}, {}).fog.x, kLargestFloat);
  EXPECT_EQ(pack_fog_light_block({FogMode::exp, 1e300}, {}, {}, {}).fog.x, kLargestFloat);
  EXPECT_EQ(pack_fog_light_block({FogMode::exp, 0}, {}, {}, {}).fog.x, 0);
}

TEST(FogLightBlock, BlockHoldsFromNoLightToAsManyAsFit) {
  EXPECT_EQ(pack_fog_light_block({}, {}, {}, {}).fog.z, 0);
  const std::vector<PlacedLight> lights(kMaxFogLights, distinct_light());
  const std::vector<FogIntensity> solutions(kMaxFogLights, kSolution);
  const FogLightBlock block = pack_fog_light_block({}, {}, lights, solutions);
  EXPECT_EQ(block.fog.z, float(kMaxFogLights));
  EXPECT_EQ(block.lights.back().color_intensity.w, 0.375f);
}

TEST(FogLightBlock, TooManyLightsMissingSolutionsOrWrongFogAreAnError) {
  const std::vector<PlacedLight> lights(kMaxFogLights + 1, distinct_light());
  const std::vector<FogIntensity> solutions(kMaxFogLights + 1, kSolution);
  const std::span<const PlacedLight> two(lights.data(), 2);
  EXPECT_EQ(error_of([&] { pack_fog_light_block({}, {}, lights, solutions); }), "lights = 129: must be at most 128");
  EXPECT_EQ(error_of([&] { pack_fog_light_block({}, {}, two, std::span(solutions.data(), 1)); }),
            "solutions = 1: must be as many as the lights");
  EXPECT_EQ(error_of([&] { pack_fog_light_block({}, {}, two, std::span(solutions.data(), 3)); }),
            "solutions = 3: must be as many as the lights");
  EXPECT_EQ(error_of([&] { pack_fog_light_block({FogMode::exp, -1}, {}, {}, {}); }), "fog.density = -1: must be >= 0");
}

}  // namespace
}  // namespace litfog::test
