// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

namespace litfog::gl {

/// Owns one OpenGL object: creates and deletes it by its name, can be moved but not copied.
///
/// threads  creation, use and destruction need a current context on the calling thread: the same each time, or one that
///          shares its objects
template <unsigned (*create)(), void (*destroy)(unsigned)>
class GlName {
 public:
  GlName() : id_(create()) {}
  ~GlName() {
    if (id_ != 0) destroy(id_);
  }
  GlName(GlName&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
  GlName& operator=(GlName&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
  }

  unsigned id() const { return id_; }  ///< 0 if moved from

 private:
  unsigned id_;
};

unsigned create_buffer();
unsigned create_framebuffer();
unsigned create_program();
unsigned create_renderbuffer();
unsigned create_texture();
unsigned create_vertex_array();

void delete_buffer(unsigned id);
void delete_framebuffer(unsigned id);
void delete_program(unsigned id);
void delete_renderbuffer(unsigned id);
void delete_texture(unsigned id);
void delete_vertex_array(unsigned id);

using BufferName = GlName<create_buffer, delete_buffer>;
using FramebufferName = GlName<create_framebuffer, delete_framebuffer>;
using ProgramName = GlName<create_program, delete_program>;
using RenderbufferName = GlName<create_renderbuffer, delete_renderbuffer>;
using TextureName = GlName<create_texture, delete_texture>;
using VertexArrayName = GlName<create_vertex_array, delete_vertex_array>;

}  // namespace litfog::gl
