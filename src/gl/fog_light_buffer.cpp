// SPDX-License-Identifier: Apache-2.0
#include "litfog/gl/fog_light_buffer.h"

#include <epoxy/gl.h>

#include <cstddef>
#include <string>

#include "litfog/gl/unsupported.h"

namespace litfog::gl {

FogLightBuffer::FogLightBuffer() {
  glBindBuffer(GL_UNIFORM_BUFFER, name_.id());
  glBufferData(GL_UNIFORM_BUFFER, sizeof(FogLightBlock), nullptr, GL_DYNAMIC_DRAW);
}

void FogLightBuffer::upload(const FogLightBlock& block) {
  glBindBuffer(GL_UNIFORM_BUFFER, name_.id());
  glBufferSubData(GL_UNIFORM_BUFFER, 0, sizeof(block), &block);
}

void FogLightBuffer::bind(const Program& program, unsigned binding) const {
  const GLuint index = glGetUniformBlockIndex(program.id(), "LitfogLightBlock");
  if (index != GL_INVALID_INDEX) glUniformBlockBinding(program.id(), index, binding);
  glBindBufferBase(GL_UNIFORM_BUFFER, binding, name_.id());
}

void check_fog_light_layout(const Program& program) {
  const auto check = [&](const std::string& name, std::size_t expected) {
    const char* const pointer = name.c_str();
    GLuint index = GL_INVALID_INDEX;
    glGetUniformIndices(program.id(), 1, &pointer, &index);
    GLint offset = -1;
    if (index != GL_INVALID_INDEX) glGetActiveUniformsiv(program.id(), 1, &index, GL_UNIFORM_OFFSET, &offset);
    if (offset != GLint(expected)) {
      throw Unsupported("LitfogLightBlock: the driver puts " + name + " at byte " + std::to_string(offset) +
                        ", std140 has it at " + std::to_string(expected));
    }
  };
  check("litfog_fog", offsetof(FogLightBlock, fog));
  check("litfog_ambient_fog_color", offsetof(FogLightBlock, ambient_fog_color));
  for (const std::size_t i : {std::size_t{0}, std::size_t{1}, kMaxFogLights - 1}) {
    const std::string light = "litfog_lights[" + std::to_string(i) + "].";
    const std::size_t base = offsetof(FogLightBlock, lights) + i * sizeof(FogLight);
    check(light + "position_extent", base + offsetof(FogLight, position_extent));
    check(light + "axis_profile", base + offsetof(FogLight, axis_profile));
    check(light + "color_intensity", base + offsetof(FogLight, color_intensity));
    check(light + "attenuation", base + offsetof(FogLight, attenuation));
    check(light + "cone", base + offsetof(FogLight, cone));
  }
}

}  // namespace litfog::gl
