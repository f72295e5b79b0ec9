// SPDX-License-Identifier: Apache-2.0
#include "litfog/gl/fog_light_tables.h"

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "core/value_errors.h"
#include "gl/shader_test.h"
#include "litfog/gl/unsupported.h"

namespace litfog::test {
namespace {

PlacedLight draw_light(Random& random) {
  PlacedLight placed;
  placed.light.attenuation = {1, random.chance(0.1) ? random.uniform(0.01, 1) : random.pick(std::array{0.1, 0.2}), 0};
  placed.light.color = {random.uniform(0, 1), random.uniform(0, 1), 1};
  placed.carried = random.chance(0.8);
  return placed;
}

class FogLightTables : public GlTest {
 protected:
  /// The members of each light, as a shader reads them.
  static std::vector<glm::vec4> read(const gl::FogLightTables& tables, std::size_t lights) {
    const gl::Program program = FormulaPixels::program(R"(
#include "litfog/shaders/light_buffer.glsl"
#include "test/input.glsl"
void main() {
  LitfogLight light = litfog_buffered_light(int(given(0).x));
  vec4 fields[5] = vec4[5](light.position_extent, light.axis_profile, light.color_intensity, light.attenuation,
                           light.cone);
  result = fields[int(given(0).y)];
}
)");
    program.use();
    tables.bind_textures(program, 1, 2);
    std::vector<glm::vec4> indices;
    for (std::size_t i = 0; i < lights; ++i) {
      for (int field = 0; field < 5; ++field) indices.emplace_back(i, field, 0, 0);
    }
    return FormulaPixels().draw(program, {indices});
  }

  static std::vector<glm::vec4> expected(const FogUpdater& updater) {
    std::vector<glm::vec4> members;
    for (const FogLightInstance& instance : updater.instances()) {
      const auto light = shader_light(updater.kinds()[std::size_t(instance.position_kind.w)], instance);
      members.insert(members.end(), light.begin(), light.end());
    }
    return members;
  }
};

TEST_F(FogLightTables, TablesFollowAnUpdaterAsTheyGrow) {
  Random random(57);
  FogUpdater updater(0);
  std::vector<FogLightHandle> handles;
  gl::FogLightTables tables;
  updater.set_fog({FogMode::exp2, 0.1});  // not uploaded
  for (int step = 0; step < 40; ++step) {
    for (int i = 0; i < 10; ++i) handles.push_back(updater.add(draw_light(random)));
    for (int i = 0; i < 10; ++i) updater.change(random.pick(handles), draw_light(random));
    for (int i = 0; i < 10; ++i) updater.switch_light(random.pick(handles), random.chance(0.5));
    updater.remove(handles[std::size_t(step)]);
    handles.erase(handles.begin() + step);
    for (const double density : {random.log_uniform(1e-3, 1), random.log_uniform(1e-3, 1)}) {
      const FogLightChanges changes = updater.set_fog({FogMode::exp, density});
      tables.upload(updater.kinds(), updater.instances(), changes);
    }
    ASSERT_EQ(read(tables, updater.instances().size()), expected(updater)) << "step " << step;
  }
}

TEST_F(FogLightTables, TablesWithoutLightsCanBeBound) {
  gl::FogLightTables tables;
  tables.bind_textures(1, 2);
  tables.upload({}, {}, {});
  tables.bind_textures(1, 2);
  tables.bind_storage(1, 2);
}

TEST_F(FogLightTables, ContextOfOpenGlEsHasNone) {
  const GlesContext gles;
  EXPECT_THROW(gl::FogLightTables(), gl::Unsupported);
}

TEST_F(FogLightTables, StorageThatTheDriverLacksIsUnsupported) {
  if (epoxy_has_gl_extension("GL_ARB_shader_storage_buffer_object")) GTEST_SKIP() << "the driver has them";
  const std::string sentence = sentence_of<gl::Unsupported>([] { gl::FogLightTables().bind_storage(1, 2); });
  EXPECT_TRUE(sentence.starts_with("this OpenGL has no storage buffers: ")) << sentence;
}

/// What check_fog_light_storage_layout says of a program with these storage buffers.
std::string error_of_storage(const std::string& buffers) {
  const gl::Program program =
      FormulaPixels::program("\n#extension GL_ARB_shader_storage_buffer_object : require\n" + buffers +
                             "out vec4 result;\nvoid main() { result = litfog_kind_buffer[1].cone_scale_intensity + "
                             "litfog_instance_buffer[1].color; }\n");
  return sentence_of<gl::Unsupported>([&] { gl::check_fog_light_storage_layout(program); });
}

TEST_F(FogLightTables, StorageOfAnotherLayoutIsAnError) {
  const auto buffers = [](const std::string& kind_members, const std::string& instance_members) {
    return "struct Kind { " + kind_members + " };\nstruct Instance { " + instance_members +
           " };\nlayout(std430) buffer Kinds { Kind litfog_kind_buffer[]; };\n"
           "layout(std430) buffer Instances { Instance litfog_instance_buffer[]; };\n";
  };
  const std::string kind = "vec4 attenuation_extent; vec4 cone_scale_intensity;";
  const std::string instance = "vec4 position_kind; vec4 axis_profile; vec4 color;";
  EXPECT_EQ(error_of_storage(buffers(kind, instance)), "no error");
  EXPECT_EQ(
      error_of_storage(buffers("vec4 cone_scale_intensity; vec4 attenuation_extent;", instance)),
      "the driver puts litfog_kind_buffer[0].attenuation_extent at byte 16, entries 32 bytes apart; std430 has it "
      "at 0, 32 apart");
  EXPECT_EQ(error_of_storage(buffers(kind, instance + " vec4 extra;")),
            "the driver puts litfog_instance_buffer[0].position_kind at byte 0, entries 64 bytes apart; std430 has it "
            "at 0, 48 apart");
}

}  // namespace
}  // namespace litfog::test
