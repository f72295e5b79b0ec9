// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <epoxy/gl.h>

#include <glm/glm.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "litfog/gl/program.h"

namespace litfog::render {

// Sets a uniform of the program in use, by name. A uniform that the compiler dropped is ignored.

inline void set_uniform(const gl::Program& program, const char* name, const glm::mat4& value) {
  glUniformMatrix4fv(program.uniform(name), 1, GL_FALSE, glm::value_ptr(value));
}
inline void set_uniform(const gl::Program& program, const char* name, const glm::vec4& value) {
  glUniform4fv(program.uniform(name), 1, glm::value_ptr(value));
}
inline void set_uniform(const gl::Program& program, const char* name, const glm::vec3& value) {
  glUniform3fv(program.uniform(name), 1, glm::value_ptr(value));
}
inline void set_uniform(const gl::Program& program, const char* name, const glm::vec2& value) {
  glUniform2fv(program.uniform(name), 1, glm::value_ptr(value));
}
inline void set_uniform(const gl::Program& program, const char* name, const glm::ivec2& value) {
  glUniform2iv(program.uniform(name), 1, glm::value_ptr(value));
}
inline void set_uniform(const gl::Program& program, const char* name, float value) {
  glUniform1f(program.uniform(name), value);
}
/// A bool is 0 or 1.
inline void set_uniform(const gl::Program& program, const char* name, int value) {
  glUniform1i(program.uniform(name), value);
}
/// A sampler's value is its texture unit.
inline void set_uniform(const gl::Program& program, const char* name, unsigned value) {
  glUniform1i(program.uniform(name), GLint(value));
}

}  // namespace litfog::render
