// SPDX-License-Identifier: Apache-2.0
#include "litfog/gl/check_errors.h"

#include <epoxy/gl.h>

#include <new>
#include <stdexcept>
#include <string>

namespace litfog::gl {

void check_errors(const char* action) {
  if (const GLenum error = glGetError(); error != GL_NO_ERROR) {
    if (error == GL_OUT_OF_MEMORY) throw std::bad_alloc();
    throw std::logic_error("OpenGL error " + std::to_string(error) + " after " + action);
  }
}

}  // namespace litfog::gl
