// SPDX-License-Identifier: Apache-2.0
#include "litfog/gl/fog_light_buffer.h"

#include <gtest/gtest.h>

#include <span>
#include <string>
#include <vector>

#include "core/value_errors.h"
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
                               "litfog_kinds[int(gl_FragCoord.x)].cone_scale_intensity + "
                               "litfog_instances[int(gl_FragCoord.x)].color; }\n");
    return sentence_of<gl::Unsupported>([&] { gl::check_fog_light_layout(program); });
  }

  static constexpr const char* kKindMembers = "vec4 attenuation_extent; vec4 cone_scale_intensity;";
  static constexpr const char* kInstanceMembers = "vec4 position_kind; vec4 axis_profile; vec4 color;";
  static constexpr const char* kBlockMembers =
      "vec4 litfog_fog; vec4 litfog_ambient_fog_color; vec4 litfog_phase_lobes[2]; vec4 litfog_density_knots[8]; "
      "LitfogKind litfog_kinds[200]; "
      "LitfogInstance "
      "litfog_instances[200];";

  static std::string error_of_members(const std::string& kind_members, const std::string& instance_members,
                                      const std::string& block_members) {
    return error_of_block("struct LitfogKind { " + kind_members + " };\nstruct LitfogInstance { " + instance_members +
                          " };\nlayout(std140) uniform LitfogLightBlock { " + block_members + " };\n");
  }
};

TEST_F(FogLightLayout, DriversLayoutIsOurs) {
  EXPECT_EQ(error_of_block("#include \"litfog/shaders/light_block.glsl\"\n"), "no error");
}

TEST_F(FogLightLayout, BlockWithTheSameMembersIsAccepted) {
  EXPECT_EQ(error_of_members(kKindMembers, kInstanceMembers, kBlockMembers), "no error");
}

TEST_F(FogLightLayout, SwappedMembersAreAnError) {
  EXPECT_EQ(error_of_members("vec4 cone_scale_intensity; vec4 attenuation_extent;", kInstanceMembers, kBlockMembers),
            "LitfogLightBlock: the driver puts litfog_kinds[0].attenuation_extent at byte 208, std140 has it at 192");
  EXPECT_EQ(error_of_members(kKindMembers, "vec4 axis_profile; vec4 position_kind; vec4 color;", kBlockMembers),
            "LitfogLightBlock: the driver puts litfog_instances[0].position_kind at byte 6608, std140 has it at 6592");
}

TEST_F(FogLightLayout, ExtraMemberIsAnError) {
  EXPECT_EQ(error_of_members(std::string(kKindMembers) + "vec4 extra;", kInstanceMembers, kBlockMembers),
            "LitfogLightBlock: the driver puts litfog_instances[0].position_kind at byte 9792, std140 has it at 6592");
  EXPECT_EQ(error_of_members(kKindMembers, std::string(kInstanceMembers) + "vec4 extra;", kBlockMembers),
            "LitfogLightBlock: the driver puts litfog_instances[1].position_kind at byte 6656, std140 has it at 6640");
}

TEST_F(FogLightLayout, SwappedFogAndAmbientColorAreAnError) {
  EXPECT_EQ(error_of_members(kKindMembers, kInstanceMembers,
                             "vec4 litfog_ambient_fog_color; vec4 litfog_fog; LitfogKind litfog_kinds[200]; "
                             "LitfogInstance litfog_instances[200];"),
            "LitfogLightBlock: the driver puts litfog_fog at byte 16, std140 has it at 0");
}

TEST_F(FogLightLayout, TooFewLightsAreAnError) {
  EXPECT_EQ(error_of_members(kKindMembers, kInstanceMembers,
                             "vec4 litfog_fog; vec4 litfog_ambient_fog_color; vec4 litfog_phase_lobes[2]; vec4 "
                             "litfog_density_knots[8]; LitfogKind litfog_kinds[200]; "
                             "LitfogInstance litfog_instances[64];"),
            "LitfogLightBlock: the driver puts litfog_instances[199].position_kind at byte -1, std140 has it at 16144");
}

/// What a driver reads of a buffer into which an updater's tables went.
class FogLightBuffer : public GlTest {
 protected:
  static constexpr Fog kFog{FogMode::exp, 0.01};

  static FogHeader header(const FogUpdater& updater) {
    return pack_fog_header({.fog = kFog, .ambient_fog_color = glm::dvec3{0.5}}, updater.instances().size());
  }

  /// A member of every instance and kind of the block, and the header.
  static std::vector<glm::vec4> read(const gl::FogLightBuffer& buffer, std::size_t lights) {
    const gl::Program program = FormulaPixels::program(
        "#include \"litfog/shaders/light_block.glsl\"\n#include \"test/input.glsl\"\n"
        "void main() {\n"
        "  int i = int(given(0).x);\n"
        "  vec4 values[4] = vec4[4](litfog_fog, litfog_ambient_fog_color, litfog_kinds[i].cone_scale_intensity,\n"
        "                           litfog_instances[i].color);\n"
        "  result = values[int(given(0).y)];\n"
        "}\n");
    buffer.bind(program, 3);
    std::vector<glm::vec4> indices{{0, 0, 0, 0}, {0, 1, 0, 0}};
    for (std::size_t i = 0; i < lights; ++i) indices.insert(indices.end(), {{i, 2, 0, 0}, {i, 3, 0, 0}});
    return FormulaPixels().draw(program, {indices});
  }

  static std::vector<glm::vec4> expected(const FogUpdater& updater) {
    const FogHeader block_header = header(updater);
    std::vector<glm::vec4> values{block_header.fog, block_header.ambient_fog_color};
    for (std::size_t i = 0; i < updater.instances().size(); ++i) {
      values.push_back(updater.kinds()[i].cone_scale_intensity);
      values.push_back(updater.instances()[i].color);
    }
    return values;
  }

  static PlacedLight light(double linear) {
    PlacedLight placed;
    placed.light.attenuation = {1, linear, 0};
    placed.carried = true;
    return placed;
  }
};

TEST_F(FogLightBuffer, BlockFollowsAnUpdater) {
  FogUpdater updater(0);
  std::vector<FogLightHandle> handles;
  for (int i = 0; i < 5; ++i) handles.push_back(updater.add(light(0.1 + i)));
  updater.set_fog(Fog{FogMode::exp, 0.5});  // not uploaded
  gl::FogLightBuffer buffer;
  const auto upload = [&] {
    const FogLightChanges changes = updater.set_fog(kFog);
    buffer.upload(header(updater), updater.kinds(), updater.instances(), changes);
  };
  updater.switch_light(handles[1], false);
  upload();
  EXPECT_EQ(read(buffer, 5), expected(updater));
  updater.switch_light(handles[3], false);
  updater.switch_light(handles[1], true);
  updater.add(light(100));
  upload();
  EXPECT_EQ(read(buffer, 6), expected(updater));
  buffer.upload(FogLightBlock{});
  upload();
  EXPECT_EQ(read(buffer, 6), expected(updater));
}

TEST_F(FogLightBuffer, FogAloneLeavesTheLights) {
  FogUpdater updater(0);
  for (int i = 0; i < 5; ++i) updater.add(light(0.1 + i));
  gl::FogLightBuffer buffer;
  buffer.upload({}, updater.kinds(), updater.instances(), updater.set_fog(kFog));
  buffer.upload(header(updater));
  EXPECT_EQ(read(buffer, 5), expected(updater));
}

TEST_F(FogLightBuffer, MoreLightsThanTheBlockHoldsAreAnError) {
  const std::vector<FogLightKind> kinds(201);
  const std::vector<FogLightInstance> instances(201);
  gl::FogLightBuffer buffer;
  EXPECT_EQ(error_of([&] { buffer.upload({}, kinds, std::span(instances).first(1), {}); }),
            "kinds = 201: must be at most 200");
  EXPECT_EQ(error_of([&] { buffer.upload({}, std::span(kinds).first(1), instances, {}); }),
            "instances = 201: must be at most 200");
  EXPECT_EQ(error_of([&] { buffer.upload({}, std::span(kinds).first(200), std::span(instances).first(200), {}); }),
            "no error");
}

}  // namespace
}  // namespace litfog::test
