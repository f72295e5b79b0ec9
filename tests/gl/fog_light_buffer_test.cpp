// SPDX-License-Identifier: Apache-2.0
#include "litfog/gl/fog_light_buffer.h"

#include <gtest/gtest.h>

#include <string>

#include "gl/formula_pixels.h"
#include "gl/gl_test.h"

namespace litfog::test {
namespace {

class FogLightLayout : public GlTest {
 protected:
  /// What check_fog_light_layout says of a program with this uniform block.
  static std::string error_of_block(const std::string& block) {
    const gl::Program program =
        FormulaPixels::program(block +
                               "out vec4 result;\nvoid main() { result = litfog_fog + litfog_ambient_fog_color + "
                               "litfog_lights[int(gl_FragCoord.x)].cone; }\n");
    try {
      gl::check_fog_light_layout(program);
    } catch (const gl::Unsupported& error) {
      return error.what();
    }
    return "accepted";
  }

  static constexpr const char* kLightMembers =
      "vec4 position_extent; vec4 axis_profile; vec4 color_intensity; vec4 attenuation; vec4 cone;";
  static constexpr const char* kBlockMembers =
      "vec4 litfog_fog; vec4 litfog_ambient_fog_color; LitfogLight litfog_lights[128];";

  static std::string error_of_members(const std::string& light_members, const std::string& block_members) {
    return error_of_block("struct LitfogLight { " + light_members + " };\nlayout(std140) uniform LitfogLightBlock { " +
                          block_members + " };\n");
  }
};

TEST_F(FogLightLayout, DriversLayoutIsOurs) {
  EXPECT_EQ(error_of_block("#include \"litfog/shaders/light_block.glsl\"\n"), "accepted");
}

TEST_F(FogLightLayout, BlockWithTheSameMembersIsAccepted) {
  EXPECT_EQ(error_of_members(kLightMembers, kBlockMembers), "accepted");
}

TEST_F(FogLightLayout, SwappedMembersAreAnError) {
  EXPECT_EQ(
      error_of_members("vec4 axis_profile; vec4 position_extent; vec4 color_intensity; vec4 attenuation; vec4 cone;",
                       kBlockMembers),
      "LitfogLightBlock: the driver puts litfog_lights[0].position_extent at byte 48, std140 has it at 32");
}

TEST_F(FogLightLayout, ExtraMemberIsAnError) {
  EXPECT_EQ(error_of_members(std::string(kLightMembers) + "vec4 extra;", kBlockMembers),
            "LitfogLightBlock: the driver puts litfog_lights[1].position_extent at byte 128, std140 has it at 112");
}

TEST_F(FogLightLayout, SwappedFogAndAmbientColorAreAnError) {
  EXPECT_EQ(error_of_members(kLightMembers,
                             "vec4 litfog_ambient_fog_color; vec4 litfog_fog; LitfogLight litfog_lights[128];"),
            "LitfogLightBlock: the driver puts litfog_fog at byte 16, std140 has it at 0");
}

TEST_F(FogLightLayout, TooFewLightsAreAnError) {
  EXPECT_EQ(
      error_of_members(kLightMembers, "vec4 litfog_fog; vec4 litfog_ambient_fog_color; LitfogLight litfog_lights[64];"),
      "LitfogLightBlock: the driver puts litfog_lights[127].position_extent at byte -1, std140 has it at 10192");
}

}  // namespace
}  // namespace litfog::test
