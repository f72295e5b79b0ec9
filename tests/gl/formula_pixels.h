// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <epoxy/gl.h>

#include <glm/vec4.hpp>
#include <span>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "litfog/gl/gl_name.h"
#include "litfog/gl/program.h"

namespace litfog::test {

/// Formulas evaluated by the driver: a row of float pixels, one a point.
///
/// A test shader gets a point's numbers by given(0), given(1) ... and answers in `result`.
class FormulaPixels {
 public:
  static constexpr gl::ShaderSource kVertexShader{"test/row.vert", R"(
void main() { gl_Position = vec4(4 * (gl_VertexID & 1) - 1, 4 * (gl_VertexID >> 1) - 1, 0.0, 1.0); }
)"};
  static constexpr gl::ShaderSource kInputs{"test/input.glsl", R"(
uniform sampler2D test_inputs;  // a column a point
out vec4 result;
vec4 given(int row) { return texelFetch(test_inputs, ivec2(int(gl_FragCoord.x), row), 0); }
)"};

  /// The program of a test shader's text.
  static gl::Program program(std::string_view text) {
    const gl::ShaderSource files[] = {kVertexShader, kInputs, {"test/formula.frag", text}};
    return gl::Program(kVertexShader.name, "test/formula.frag", files);
  }

  /// One result a point; inputs[k][i] is point i's given(k). At most 8192 points.
  std::vector<glm::vec4> draw(const gl::Program& program, const std::vector<std::vector<glm::vec4>>& inputs) {
    const auto count = GLsizei(inputs.at(0).size());
    std::vector<glm::vec4> texels;
    for (const auto& row : inputs) texels.insert(texels.end(), row.begin(), row.end());
    glActiveTexture(GL_TEXTURE0);
    set_image(inputs_.id(), count, GLsizei(inputs.size()), texels.data());
    set_image(results_.id(), count, 1, nullptr);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, results_.id(), 0);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
      throw std::runtime_error("the driver does not draw float pixels");
    }
    glBindTexture(GL_TEXTURE_2D, inputs_.id());
    glViewport(0, 0, count, 1);
    glDisable(GL_BLEND);
    glDisable(GL_DEPTH_TEST);
    glBindVertexArray(vertex_array_.id());
    program.use();
    glUniform1i(program.uniform("test_inputs"), 0);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    std::vector<glm::vec4> results(inputs[0].size());
    glReadPixels(0, 0, count, 1, GL_RGBA, GL_FLOAT, results.data());
    return results;
  }

 private:
  static void set_image(GLuint texture, GLsizei width, GLsizei height, const void* texels) {
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT, texels);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  }

  gl::VertexArrayName vertex_array_;
  gl::FramebufferName framebuffer_;
  gl::TextureName inputs_;
  gl::TextureName results_;
};

}  // namespace litfog::test
