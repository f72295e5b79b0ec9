// SPDX-License-Identifier: Apache-2.0
#include "render/gpu/sampler_states.h"

#include <epoxy/gl.h>

#include <vector>

#include "render/gpu/render_shaders.h"
#include "render/gpu/texture_unit.h"

namespace litfog::render {

SamplerStates::SamplerStates()
    : program_("whole_picture.vert", "all_samplers.frag", render_shaders()), texture_(glm::vec4(0)) {
  constexpr int kSamplers = 16;  // the number that OpenGL 3.3 guarantees
  const std::vector<GLint> units(kSamplers, GLint(kUploadUnit));
  program_.use();
  glUniform1iv(program_.uniform("maps"), kSamplers, units.data());
}

void SamplerStates::set() const {
  program_.use();
  texture_.bind(kUploadUnit);
  glBindVertexArray(no_vertices_.id());
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glDisable(GL_PROGRAM_POINT_SIZE);
  glDrawArrays(GL_POINTS, 0, 1);  // one point, to no effect
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

}  // namespace litfog::render
