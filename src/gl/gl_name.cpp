// SPDX-License-Identifier: Apache-2.0
#include "litfog/gl/gl_name.h"

#include <epoxy/gl.h>

namespace litfog::gl {
namespace {

template <typename Generate>
GLuint generated(Generate generate) {
  GLuint id = 0;
  generate(1, &id);
  return id;
}

}  // namespace

unsigned create_buffer() { return generated(glGenBuffers); }
unsigned create_framebuffer() { return generated(glGenFramebuffers); }
unsigned create_program() { return glCreateProgram(); }
unsigned create_renderbuffer() { return generated(glGenRenderbuffers); }
unsigned create_texture() { return generated(glGenTextures); }
unsigned create_vertex_array() { return generated(glGenVertexArrays); }

void delete_buffer(unsigned id) { glDeleteBuffers(1, &id); }
void delete_framebuffer(unsigned id) { glDeleteFramebuffers(1, &id); }
void delete_program(unsigned id) { glDeleteProgram(id); }
void delete_renderbuffer(unsigned id) { glDeleteRenderbuffers(1, &id); }
void delete_texture(unsigned id) { glDeleteTextures(1, &id); }
void delete_vertex_array(unsigned id) { glDeleteVertexArrays(1, &id); }

}  // namespace litfog::gl
