// SPDX-License-Identifier: Apache-2.0
#include "litfog/gl/gl_name.h"

#include <epoxy/gl.h>

namespace litfog::gl {
namespace {

/// Also calls the delete function with nothing to delete: libepoxy loads functions at their first call, and ends the
/// process if the context has gone by then.
template <typename Generate, typename Delete>
GLuint generated(Generate generate, Delete remove) {
  GLuint id = 0;
  generate(1, &id);
  remove(0, nullptr);
  return id;
}

}  // namespace

unsigned create_buffer() { return generated(glGenBuffers, glDeleteBuffers); }
unsigned create_framebuffer() { return generated(glGenFramebuffers, glDeleteFramebuffers); }
unsigned create_program() {
  glDeleteProgram(0);  // as above
  return glCreateProgram();
}
unsigned create_renderbuffer() { return generated(glGenRenderbuffers, glDeleteRenderbuffers); }
unsigned create_texture() { return generated(glGenTextures, glDeleteTextures); }
unsigned create_vertex_array() { return generated(glGenVertexArrays, glDeleteVertexArrays); }

void delete_buffer(unsigned id) { glDeleteBuffers(1, &id); }
void delete_framebuffer(unsigned id) { glDeleteFramebuffers(1, &id); }
void delete_program(unsigned id) { glDeleteProgram(id); }
void delete_renderbuffer(unsigned id) { glDeleteRenderbuffers(1, &id); }
void delete_texture(unsigned id) { glDeleteTextures(1, &id); }
void delete_vertex_array(unsigned id) { glDeleteVertexArrays(1, &id); }

}  // namespace litfog::gl
