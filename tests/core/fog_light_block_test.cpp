// SPDX-License-Identifier: Apache-2.0
#include "litfog/fog_light_block.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "core/value_errors.h"
#include "reference/double_limits.h"

namespace litfog::test {
namespace {

constexpr float kMaxFloat = std::numeric_limits<float>::max();

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

TEST(FogLightKind, EveryFieldIsInItsPlace) {
  const FogLightKind packed = pack_fog_light_kind(distinct_light(), kSolution);
  EXPECT_EQ(packed.attenuation_extent, glm::vec4(1.5, 0.125, 0.0625, 40));
  EXPECT_EQ(packed.cone_scale_intensity, glm::vec4(float(std::cos(0.5)), 8, 0.4f, 0.375));
}

TEST(FogLightInstance, EveryFieldIsInItsPlace) {
  const FogLightInstance packed = pack_fog_light_instance(distinct_light(), 7);
  EXPECT_EQ(packed.position_kind, glm::vec4(1, -2, 3, 7));
  EXPECT_EQ(packed.axis_profile, glm::vec4(0, 0.6f, -0.8f, 1));
  EXPECT_EQ(packed.color, glm::vec4(0.25, 0.5, 0.75, 0));
}

TEST(FogLightInstance, LargestKindIsExact) {
  EXPECT_EQ(pack_fog_light_instance(distinct_light(), 16'777'215).position_kind.w, 16'777'215.0f);
  EXPECT_EQ(pack_fog_light_instance(distinct_light(), 16'777'216).position_kind.w, 16'777'216.0f);
  EXPECT_EQ(error_of([] { pack_fog_light_instance(distinct_light(), 16'777'217); }),
            "kind = 16777217: must be at most 16777216");
}

TEST(FogLightKind, ProfilesAreNumbered) {
  PlacedLight light = distinct_light();
  light.light.cone = Cone::smoothstep(0.25, 0.75);
  const glm::vec4 dual = pack_fog_light_kind(light, kSolution).cone_scale_intensity;
  EXPECT_EQ(pack_fog_light_instance(light, 0).axis_profile.w, 2);
  EXPECT_EQ(dual, glm::vec4(float(std::cos(0.75)), float(std::cos(0.25)), 0.4f, 0.375));
  light.light.cone = Cone{};
  EXPECT_EQ(pack_fog_light_instance(light, 0).axis_profile.w, 0);
  EXPECT_EQ(pack_fog_light_kind(light, kSolution).cone_scale_intensity, glm::vec4(0, 0, 0.4f, 0.375));
}

TEST(FogLightKind, OnlyCarriedLightsLightTheFog) {
  PlacedLight light = distinct_light();
  light.carried = false;
  EXPECT_EQ(pack_fog_light_kind(light, kSolution).cone_scale_intensity.w, 0);
}

TEST(FogLightKind, InfiniteAndOverlargeValuesBecomeTheLargestFloat) {
  PlacedLight light = distinct_light();
  light.light.attenuation = {1e300, 1e200, 1e100};
  light.light.density_scale = 1e300;
  const FogLightKind packed = pack_fog_light_kind(
      light, {.intensity = 1, .peak_range = kInfinity, .extent = kInfinity, .status = SolveStatus::ok});
  EXPECT_EQ(packed.attenuation_extent, glm::vec4(kMaxFloat));
  EXPECT_EQ(packed.cone_scale_intensity.z, kMaxFloat);
  EXPECT_EQ(pack_fog_light_kind(light, {.intensity = 1, .peak_range = 0, .extent = 1e39, .status = SolveStatus::ok})
                .attenuation_extent.w,
            kMaxFloat);
  light.light.color = {1e300, 2, 1e39};
  EXPECT_EQ(pack_fog_light_instance(light, 0).color, glm::vec4(kMaxFloat, 2, kMaxFloat, 0));
}

TEST(FogLightKind, WronglyPlacedLightIsAnError) {
  const auto error_after = [](const auto& change) {
    PlacedLight light = distinct_light();
    change(light);
    const std::string error = error_of([&] { pack_fog_light_kind(light, kSolution); });
    EXPECT_EQ(error_of([&] { pack_fog_light_instance(light, 0); }), error);
    return error;
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
  EXPECT_EQ(error_of([&] { pack_fog_light_block({}, lights, solutions); }),
            "position.x = nan: must be at most 16777216 in magnitude");
}

TEST(FogLightBlock, AmbientFogColorThatIsNoLightIsAnError) {
  const auto error_with = [](const glm::dvec3& color) {
    return error_of([&] { pack_fog_light_block({.ambient_fog_color = color}, {}, {}); });
  };
  EXPECT_EQ(error_with({kNan, 0, 0}), "ambient_fog_color.r = nan: must be finite and >= 0");
  EXPECT_EQ(error_with({0, -1, 0}), "ambient_fog_color.g = -1: must be finite and >= 0");
  EXPECT_EQ(error_with({0, 0, kInfinity}), "ambient_fog_color.b = inf: must be finite and >= 0");
}

TEST(FogLightBlock, BlockHoldsFogCountAndAmbientColor) {
  const std::vector<PlacedLight> lights(3, distinct_light());
  const std::vector<FogIntensity> solutions(3, kSolution);
  const FogLightBlock exp_block =
      pack_fog_light_block({.fog = {FogMode::exp, 0.125}, .ambient_fog_color = {0.1, 0.2, 0.3}}, lights, solutions);
  EXPECT_EQ(exp_block.header.fog, glm::vec4(0.125, 0, 3, 1));
  EXPECT_EQ(exp_block.header.ambient_fog_color, glm::vec4(0.1f, 0.2f, 0.3f, 0));
  const FogLightBlock exp2_block =
      pack_fog_light_block({.fog = {FogMode::exp2, 0.25}, .ambient_fog_color = {0.1, 0.2, 0.3}}, lights, solutions);
  EXPECT_EQ(exp2_block.header.fog, glm::vec4(0.25, 1, 3, 1));
}

TEST(FogLightBlock, HeaderHoldsTheLobesOfThePhaseFunction) {
  const auto lobes = pack_fog_header({.phase = {{0.5, 2}, {-0.25, 0}, 0.75}}, 0).phase_lobes;
  EXPECT_EQ(lobes[0], glm::vec4(0.25, 1, 0.75 * 0.75 / 2, 2));  // 1 + alpha (1 + 2 g^2) / 3 is 2
  EXPECT_EQ(lobes[1], glm::vec4(0.5625, -0.5, 0.25 * 0.9375, 0));
}

TEST(FogLightBlock, NarrowestLobeIsFiniteInFloats) {
  const glm::vec4 lobe = pack_fog_header({.phase = Phase::henyey_greenstein(1 - 0x1p-53)}, 0).phase_lobes[0];
  EXPECT_GT(lobe.x * std::sqrt(lobe.x), 0.0f);
  EXPECT_TRUE(std::isfinite(lobe.z / (lobe.x * std::sqrt(lobe.x))));
}

TEST(FogLightBlock, HeaderHoldsTheKnotsOfLayersWithZerosBehindThem) {
  const std::array<DensityKnot, 2> knots{{{100, 0.02}, {120, 1e300}}};
  const FogHeader header = pack_fog_header({.profile = make_density_profile(knots)}, 0);
  EXPECT_EQ(header.ambient_fog_color.w, 2);
  EXPECT_EQ(header.density_knots[0], glm::vec4(100, 0.02f, 0, 0));
  EXPECT_EQ(header.density_knots[1], glm::vec4(120, kMaxKnotDensity, 0, 0));
  for (std::size_t i = 2; i < kMaxDensityKnots; ++i) EXPECT_EQ(header.density_knots[i], glm::vec4(0)) << i;
}

TEST(FogLightBlock, LightsAreInOrderWithZerosBehindThem) {
  std::vector<PlacedLight> lights(3, distinct_light());
  std::vector<FogIntensity> solutions(3, kSolution);
  for (int i = 0; i < 3; ++i) {
    lights[std::size_t(i)].position.x = 10 * i;
    solutions[std::size_t(i)].intensity = 0.25 * i;
  }
  const FogLightBlock block = pack_fog_light_block({}, lights, solutions);
  for (int i = 0; i < 3; ++i) {
    const FogLightInstance& instance = block.instances[std::size_t(i)];
    EXPECT_EQ(instance.position_kind, glm::vec4(10 * i, -2, 3, i));
    EXPECT_EQ(block.kinds[std::size_t(i)].cone_scale_intensity.w, 0.25f * float(i));
  }
  const FogLightKind unused_kind{};
  const FogLightInstance unused_instance{};
  for (std::size_t i = 3; i < kMaxFogLights; ++i) {
    EXPECT_EQ(std::memcmp(&block.kinds[i], &unused_kind, sizeof unused_kind), 0) << "kind " << i;
    EXPECT_EQ(std::memcmp(&block.instances[i], &unused_instance, sizeof unused_instance), 0) << "instance " << i;
  }
}

TEST(FogLightBlock, HeaderOfMoreInstancesThanTheBlockHasIsAnError) {
  EXPECT_EQ(pack_fog_header({}, kMaxFogLights).fog.z, float(kMaxFogLights));
  EXPECT_EQ(error_of([] { pack_fog_header({}, kMaxFogLights + 1); }), "instances = 201: must be at most 200");
}

TEST(FogLightBlock, TotalFogBecomesTheLargestFloat) {
  EXPECT_EQ(pack_fog_light_block({{FogMode::exp, kInfinity}}, {}, {}).header.fog.x, kMaxFloat);
  EXPECT_EQ(pack_fog_light_block({{FogMode::exp, 1e300}}, {}, {}).header.fog.x, kMaxFloat);
  EXPECT_EQ(pack_fog_light_block({{FogMode::exp, 0}}, {}, {}).header.fog.x, 0);
}

TEST(FogLightBlock, BlockHoldsFromNoLightToAsManyAsFit) {
  EXPECT_EQ(pack_fog_light_block({}, {}, {}).header.fog.z, 0);
  const std::vector<PlacedLight> lights(kMaxFogLights, distinct_light());
  const std::vector<FogIntensity> solutions(kMaxFogLights, kSolution);
  const FogLightBlock block = pack_fog_light_block({}, lights, solutions);
  EXPECT_EQ(block.header.fog.z, float(kMaxFogLights));
  EXPECT_EQ(block.kinds.back().cone_scale_intensity.w, 0.375f);
}

TEST(FogLightBlock, TooManyLightsMissingSolutionsOrWrongFogAreAnError) {
  const std::vector<PlacedLight> lights(kMaxFogLights + 1, distinct_light());
  const std::vector<FogIntensity> solutions(kMaxFogLights + 1, kSolution);
  const std::span<const PlacedLight> two(lights.data(), 2);
  EXPECT_EQ(error_of([&] { pack_fog_light_block({}, lights, solutions); }), "lights = 201: must be at most 200");
  EXPECT_EQ(error_of([&] { pack_fog_light_block({}, two, std::span(solutions.data(), 1)); }),
            "solutions = 1: must be as many as the lights");
  EXPECT_EQ(error_of([&] { pack_fog_light_block({}, two, std::span(solutions.data(), 3)); }),
            "solutions = 3: must be as many as the lights");
  EXPECT_EQ(error_of([&] { pack_fog_light_block({{FogMode::exp, -1}}, {}, {}); }), "fog.density = -1: must be >= 0");
}

}  // namespace
}  // namespace litfog::test
