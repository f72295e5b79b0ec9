// SPDX-License-Identifier: Apache-2.0
#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <glm/vec4.hpp>
#include <string>
#include <vector>

#include "gl/formula_pixels.h"
#include "gl/gl_test.h"
#include "litfog/fog_light_block.h"
#include "litfog/gl/gl_name.h"

namespace litfog::test {
namespace {

using glm::vec4;

constexpr int kLights = 300;  // more than the block holds
constexpr int kFields = 5;

class LightBufferShader : public GlTest {
 protected:
  static vec4 expected(int light, int field) {
    const float n = float(100 * light + 4 * field);
    return {n, n + 1, n + 2, n + 3};
  }

  /// kLights times kFields texels, as FogLights lie in memory.
  static std::vector<vec4> texels() {
    std::vector<vec4> all;
    for (int light = 0; light < kLights; ++light) {
      for (int field = 0; field < kFields; ++field) all.push_back(expected(light, field));
    }
    return all;
  }

  /// Every number, read from the texture that is bound to unit 1.
  static void expect_every_number(const std::string& form) {
    const gl::Program program = FormulaPixels::program(form + R"(
#include "litfog/shaders/light_buffer.glsl"
#include "test/input.glsl"
void main() {
  LitfogLight light = litfog_buffered_light(int(given(0).x));
  vec4 fields[6] = vec4[6](light.position_extent, light.axis_profile, light.color_intensity, light.attenuation,
                           light.cone, litfog_buffered_position_extent(int(given(0).x)));
  result = fields[int(given(0).y)];
}
)");
    program.use();
    glUniform1i(program.uniform("litfog_light_buffer"), 1);
    std::vector<vec4> indices;
    for (int light = 0; light < kLights; ++light) {
      for (int field = 0; field <= kFields; ++field) indices.emplace_back(light, field, 0, 0);
    }
    const std::vector<vec4> results = FormulaPixels().draw(program, {indices});
    for (std::size_t i = 0; i < results.size(); ++i) {
      const int light = int(indices[i].x);
      const int field = int(indices[i].y);
      EXPECT_EQ(results[i], expected(light, field % kFields)) << "light " << light << ", field " << field;
    }
  }
};

static_assert(sizeof(FogLight) == kFields * sizeof(vec4));

TEST_F(LightBufferShader, EveryNumberOfABufferTextureIsRead) {
  const std::vector<vec4> data = texels();
  const gl::BufferName buffer;
  glBindBuffer(GL_TEXTURE_BUFFER, buffer.id());
  glBufferData(GL_TEXTURE_BUFFER, GLsizeiptr(data.size() * sizeof(vec4)), data.data(), GL_STATIC_DRAW);
  const gl::TextureName texture;
  glActiveTexture(GL_TEXTURE1);
  glBindTexture(GL_TEXTURE_BUFFER, texture.id());
  glTexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, buffer.id());
  expect_every_number("");
}

TEST_F(LightBufferShader, EveryNumberOfATextureWhoseRowsSplitLightsIsRead) {
  constexpr int kWidth = 12;
  static_assert(kLights * kFields % kWidth == 0 && kWidth % kFields != 0);
  const std::vector<vec4> data = texels();
  const gl::TextureName texture;
  glActiveTexture(GL_TEXTURE1);
  glBindTexture(GL_TEXTURE_2D, texture.id());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, kWidth, kLights * kFields / kWidth, 0, GL_RGBA, GL_FLOAT, data.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  expect_every_number("#define LITFOG_LIGHT_TEXTURE\n");
}

}  // namespace
}  // namespace litfog::test
