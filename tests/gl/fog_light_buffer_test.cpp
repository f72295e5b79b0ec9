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
};

TEST_F(FogLightLayout, DriversLayoutIsOurs) {
  EXPECT_EQ(error_of_block("#include \"litfog/shaders/light_block.glsl\"\n"), "accepted");
}

TEST_F(FogLightLayout, SwappedMembersAreAnError) {
  EXPECT_EQ(error_of_block(R"(
struct LitfogLight { vec4 axis_profile; vec4 position_extent; vec4 color_intensity; vec4 attenuation; vec4 cone; };
layout(std140) uniform LitfogLightBlock { vec4 litfog_fog; vec4 litfog_ambient_fog_color; LitfogLight litfog_lights[128]; };
)"),
            "LitfogLightBlock: the driver puts litfog_lights[0].position_extent at byte 48, std140 has it at 32");
}

TEST_F(FogLightLayout, ExtraMemberIsAnError) {
  EXPECT_EQ(error_of_block(R"(
struct LitfogLight { vec4 position_extent; vec4 axis_profile; vec4 color_intensity; vec4 attenuation; vec4 cone, extra; };
layout(std140) uniform LitfogLightBlock { vec4 litfog_fog; vec4 litfog_ambient_fog_color; LitfogLight litfog_lights[128]; };
)"),
            "LitfogLightBlock: the driver puts litfog_lights[1].position_extent at byte 128, std140 has it at 112");
}

TEST_F(FogLightLayout, SwappedFogAndAmbientColorAreAnError) {
  EXPECT_EQ(error_of_block(R"(
struct LitfogLight { vec4 position_extent; vec4 axis_profile; vec4 color_intensity; vec4 attenuation; vec4 cone; };
layout(std140) uniform LitfogLightBlock { vec4 litfog_ambient_fog_color; vec4 litfog_fog; LitfogLight litfog_lights[128]; };
)"),
            "LitfogLightBlock: the driver puts litfog_fog at byte 16, std140 has it at 0");
}

TEST_F(FogLightLayout, TooFewLightsAreAnError) {
  EXPECT_EQ(error_of_block(R"(
struct LitfogLight { vec4 position_extent; vec4 axis_profile; vec4 color_intensity; vec4 attenuation; vec4 cone; };
layout(std140) uniform LitfogLightBlock { vec4 litfog_fog; vec4 litfog_ambient_fog_color; LitfogLight litfog_lights[64]; };
)"),
            "LitfogLightBlock: the driver puts litfog_lights[127].position_extent at byte -1, std140 has it at 10192");
}

}  // namespace
}  // namespace litfog::test
