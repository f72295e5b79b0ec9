// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <epoxy/gl.h>

#include <glm/glm.hpp>

#include "litfog/gl/gl_name.h"
#include "render/gpu/texture_unit.h"

namespace litfog::render {

/// The state of passes that draw texels: no vertex attributes, no depth test, no culling.
class TexelPass {
 public:
  void begin() const {
    glBindVertexArray(vertices_.id());
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
  }

 private:
  gl::VertexArrayName vertices_;
};

/// Attaches a rectangle texture without filtering to the bound framebuffer. shaders/airlight/texel.glsl reads it.
inline void attach_texels(GLenum attachment, const gl::TextureName& texture, glm::ivec2 size, GLint format) {
  bind_texture(kUploadUnit, texture, GL_TEXTURE_RECTANGLE);
  const bool is_integer = format == GL_RGBA32UI;
  glTexImage2D(GL_TEXTURE_RECTANGLE, 0, format, size.x, size.y, 0, is_integer ? GL_RGBA_INTEGER : GL_RGBA,
               is_integer ? GL_UNSIGNED_INT : GL_FLOAT, nullptr);
  set_filter(GL_TEXTURE_RECTANGLE, GL_NEAREST);
  glFramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_RECTANGLE, texture.id(), 0);
}

}  // namespace litfog::render
