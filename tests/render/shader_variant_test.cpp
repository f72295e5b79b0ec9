// SPDX-License-Identifier: Apache-2.0
#include "render/surface/shader_variant.h"

#include <gtest/gtest.h>

#include <vector>

namespace litfog::test {
using namespace render;

namespace {

std::vector<PackedLight> lights(std::size_t count, float profile) {
  std::vector<PackedLight> lights(count);
  for (PackedLight& light : lights) light.instance.axis_profile.w = profile;
  return lights;
}

TEST(ShaderVariant, VariantIsCompiledForEnoughLightsAndNoMoreThanTwiceAsMany) {
  for (std::size_t count = 0; count <= kMaxUniformLights; ++count) {
    EXPECT_GE(compiled_light_count(count), count);
    EXPECT_LE(compiled_light_count(count), 2 * count);
    EXPECT_EQ(compiled_light_count(compiled_light_count(count)), compiled_light_count(count));
  }
}

TEST(ShaderVariant, VariantKnowsTheProfileOfOneOrTwoLightsThatHaveOne) {
  EXPECT_EQ(compiled_for(lights(1, 2)).profile, 2);
  EXPECT_EQ(compiled_for(lights(2, 1)).profile, 1);
  EXPECT_EQ(compiled_for(lights(3, 1)).profile, UniformLights::kAnyProfile);
  EXPECT_EQ(compiled_for({}).profile, UniformLights::kAnyProfile);
  std::vector<PackedLight> mixed = lights(2, 1);
  mixed[1].instance.axis_profile.w = 0;
  EXPECT_EQ(compiled_for(mixed).profile, UniformLights::kAnyProfile);
}

TEST(ShaderVariant, ShaderOfNoLightsHasNoEmptyArray) {
  const SurfacePass pass;
  const std::string text = pass_constants({.pass = &pass});
  EXPECT_NE(text.find("uniform_light_count = 1;"), std::string::npos);
  EXPECT_NE(text.find("lights_in_pass = 0;"), std::string::npos);
}

TEST(ShaderVariant, VerticesPassConstantsOnOnlyWhereTheVariantTakesThem) {
  const SurfacePass pass;
  ShaderVariant variant{.pass = &pass};
  EXPECT_EQ(pass_constants(variant).find("#define VERTICES_PASS_CONSTANTS"), std::string::npos);
  variant.takes_constants_from_vertices = true;
  EXPECT_NE(pass_constants(variant).find("#define VERTICES_PASS_CONSTANTS"), std::string::npos);
}

TEST(ShaderVariant, PassThatSharesTheLightsOfTheFogStartsAtTheFirst) {
  const SurfacePass pass;
  ShaderVariant variant{.pass = &pass, .fog_lights = {.count = 2, .profile = 1}, .lights = {.count = 4}};
  EXPECT_NE(pass_constants(variant).find("first_light_in_pass = 2;"), std::string::npos);
  variant.shares_lights = true;
  const std::string text = pass_constants(variant);
  EXPECT_NE(text.find("first_light_in_pass = 0;"), std::string::npos);
  EXPECT_NE(text.find("lights_in_pass = 6;"), std::string::npos);
  EXPECT_NE(text.find("int[](1, 1, -1, -1, -1, -1)"), std::string::npos);
}

}  // namespace

}  // namespace litfog::test
