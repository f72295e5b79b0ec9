// SPDX-License-Identifier: Apache-2.0
#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <glm/vec4.hpp>
#include <string>
#include <vector>

#include "gl/formula_pixels.h"
#include "gl/shader_test.h"
#include "litfog/formulas.h"
#include "litfog/gl/fog_light_tables.h"
#include "litfog/gl/gl_name.h"

namespace litfog::test {
namespace {

using glm::vec4;

constexpr int kLights = 300;  // more than the block holds
constexpr int kKinds = 70;
constexpr int kFields = 5;
constexpr int kWidth = 7;  // texels: rows split entries

static_assert(kKinds * 2 % kWidth == 0 && kLights * 3 % kWidth != 0);

class LightBufferShader : public GlTest {
 protected:
  LightBufferShader() {
    const auto numbers = [](int n) { return vec4(n, n + 1, n + 2, n + 3); };
    for (int i = 0; i < kKinds; ++i) kinds_.push_back({numbers(8 * i + 1), numbers(8 * i + 5)});
    for (int i = 0; i < kLights; ++i) {
      const int n = 1000 + 12 * i;
      instances_.push_back({vec4(glm::vec3(numbers(n)), i * 17 % kKinds), numbers(n + 4), numbers(n + 8)});
    }
  }

  gl::FogLightTables uploaded_tables() const {
    gl::FogLightTables tables;
    tables.upload(kinds_, instances_, {});
    return tables;
  }

  static gl::Program program(const std::string& form) {
    return FormulaPixels::program(form + R"(
#include "litfog/shaders/light_buffer.glsl"
#include "test/input.glsl"
void main() {
  LitfogLight light = litfog_buffered_light(int(given(0).x));
  vec4 fields[6] = vec4[6](light.position_extent, light.axis_profile, light.color_intensity, light.attenuation,
                           light.cone, litfog_buffered_position_extent(int(given(0).x)));
  result = fields[int(given(0).y)];
}
)");
  }

  /// Every number, read from textures of units 1 and 2 or storage buffers that are bound.
  void expect_every_number(const gl::Program& program) const {
    program.use();
    glUniform1i(program.uniform("litfog_kind_buffer"), 1);
    glUniform1i(program.uniform("litfog_instance_buffer"), 2);
    std::vector<vec4> indices;
    for (int light = 0; light < kLights; ++light) {
      for (int field = 0; field <= kFields; ++field) indices.emplace_back(light, field, 0, 0);
    }
    const std::vector<vec4> results = FormulaPixels().draw(program, {indices});
    for (std::size_t i = 0; i < results.size(); ++i) {
      const FogLightInstance& instance = instances_[std::size_t(indices[i].x)];
      const auto expected = shader_light(kinds_[std::size_t(instance.position_kind.w)], instance);
      const auto field = std::size_t(indices[i].y);
      EXPECT_EQ(results[i], expected[field % kFields]) << "light " << indices[i].x << ", field " << field;
    }
  }

  std::vector<FogLightKind> kinds_;
  std::vector<FogLightInstance> instances_;
};

TEST_F(LightBufferShader, EveryNumberOfBufferTexturesIsRead) {
  const gl::FogLightTables tables = uploaded_tables();
  tables.bind_textures(1, 2);
  expect_every_number(program(""));
}

TEST_F(LightBufferShader, EveryNumberOfStorageBuffersIsRead) {
  const gl::FogLightTables tables = uploaded_tables();
  tables.bind_storage(3, 5);
  const gl::Program storage = program(R"(
#extension GL_ARB_shader_storage_buffer_object : require
#extension GL_ARB_shading_language_420pack : require
#define LITFOG_LIGHT_STORAGE
#define LITFOG_KIND_BINDING 3
#define LITFOG_INSTANCE_BINDING 5
)");
  gl::check_fog_light_storage_layout(storage);
  expect_every_number(storage);
}

TEST_F(LightBufferShader, EveryNumberOfTexturesWhoseRowsSplitEntriesIsRead) {
  std::array<gl::TextureName, 2> textures;
  const auto upload = [&](std::size_t i, std::vector<vec4> texels) {
    texels.resize((texels.size() + kWidth - 1) / kWidth * kWidth);
    glActiveTexture(GLenum(GL_TEXTURE1 + i));
    glBindTexture(GL_TEXTURE_2D, textures[i].id());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, kWidth, GLsizei(texels.size() / kWidth), 0, GL_RGBA, GL_FLOAT,
                 texels.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  };
  std::vector<vec4> kinds;
  for (const auto& [attenuation, cone] : kinds_) kinds.insert(kinds.end(), {attenuation, cone});
  std::vector<vec4> instances;
  for (const auto& [position, axis, color] : instances_) instances.insert(instances.end(), {position, axis, color});
  upload(0, kinds);
  upload(1, instances);
  expect_every_number(program("#define LITFOG_LIGHT_TEXTURE\n"));
}

TEST_F(LightBufferShader, CookieGetsItsInstancesNumber) {
  instances_[4].axis_profile.w = float(LITFOG_PROFILE_COOKIE);
  const gl::FogLightTables tables = uploaded_tables();
  tables.bind_textures(1, 2);
  const gl::Program cookies = FormulaPixels::program(R"(
#define LITFOG_COOKIES
#include "litfog/shaders/light_buffer.glsl"
#include "test/input.glsl"
vec4 litfog_cookie_cone(float cookie) { return vec4(cookie, 1.0, 2.0, 3.0); }
float litfog_cookie(LitfogLight light, vec3 direction) { return light.cone.x + direction.x; }
void main() {
  LitfogLight light = litfog_buffered_light(int(given(0).x));
  result = light.cone;
  if (given(0).x == 4.0) result.w = litfog_cone(light, vec3(0.25));
}
)");
  cookies.use();
  glUniform1i(cookies.uniform("litfog_kind_buffer"), 1);
  glUniform1i(cookies.uniform("litfog_instance_buffer"), 2);
  const std::vector<vec4> results = FormulaPixels().draw(cookies, {{vec4(3, 0, 0, 0), vec4(4, 0, 0, 0)}});
  const vec4 cone = kinds_[std::size_t(instances_[3].position_kind.w)].cone_scale_intensity;
  EXPECT_EQ(results[0], vec4(cone.x, cone.y, 0, 0));
  const float number = instances_[4].color.w;
  EXPECT_EQ(results[1], vec4(number, 1, 2, number + 0.25f));
}

}  // namespace
}  // namespace litfog::test
