// SPDX-License-Identifier: Apache-2.0
#include "render/surface/shader_variant.h"

#include <gtest/gtest.h>

#include <string>

namespace litfog::test {
using namespace render;

namespace {

TEST(ShaderVariant, VariantIsCompiledForEnoughLightsAndNoMoreThanTwiceAsMany) {
  for (std::size_t count = 0; count <= kMaxUniformLights; ++count) {
    EXPECT_GE(compiled_light_count(count), count);
    EXPECT_LE(compiled_light_count(count), 2 * count);
    EXPECT_EQ(compiled_light_count(compiled_light_count(count)), compiled_light_count(count));
  }
}

TEST(ShaderVariant, ShaderOfNoLightsHasNoEmptyArray) {
  const SurfacePass pass;
  const std::string text = pass_constants({.pass = &pass});
  EXPECT_NE(text.find("uniform_light_count = 1;"), std::string::npos);
  EXPECT_NE(text.find("lights_in_pass = 0;"), std::string::npos);
}

TEST(ShaderVariant, PassThatSharesTheLightsOfTheFogStartsAtTheFirst) {
  const SurfacePass pass;
  ShaderVariant variant{.pass = &pass, .fog_light_count = 2, .light_count = 4};
  EXPECT_NE(pass_constants(variant).find("first_light_in_pass = 2;"), std::string::npos);
  variant.shares_lights = true;
  const std::string text = pass_constants(variant);
  EXPECT_NE(text.find("first_light_in_pass = 0;"), std::string::npos);
  EXPECT_NE(text.find("lights_in_pass = 6;"), std::string::npos);
}

}  // namespace

}  // namespace litfog::test
