// SPDX-License-Identifier: Apache-2.0
#include "litfog/gl/program.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "tables/shader_assembly.h"

namespace litfog::gl {
namespace {

std::string_view shader_head() {
  if (epoxy_is_desktop_gl()) return "#version 330 core";
  // ES has no default precision for some types.
  return "#version 300 es\nprecision highp float;\nprecision highp int;\nprecision highp sampler2D;";
}

std::string_view text_of(std::string_view name, std::span<const ShaderSource> own_files) {
  for (std::span<const ShaderSource> files : {own_files, shader_library()}) {
    const auto found = std::ranges::find(files, name, &ShaderSource::name);
    if (found != files.end()) return found->text;
  }
  throw std::logic_error("no shader file " + std::string(name));
}

/// The driver's log, read by a glGet*iv and a glGet*InfoLog.
template <typename GetParameter, typename GetLog>
std::string info_log(GLuint object, GetParameter get_parameter, GetLog get_log) {
  GLint length = 0;
  get_parameter(object, GL_INFO_LOG_LENGTH, &length);
  std::string log(std::size_t(std::max(length, 1)), '\0');
  get_log(object, GLsizei(log.size()), &length, log.data());
  log.resize(std::size_t(length));  // drops the terminator, which would end an exception's text
  return log;
}

/// Compiles a shader into a program. It is deleted with the program.
void add_shader(GLuint program, GLenum stage, std::string_view name, std::span<const ShaderSource> files) {
  ShaderAssembly assembly([files](std::string_view file) { return text_of(file, files); });
  assembly.add_line(shader_head());
  assembly.add_file(name);
  const GLuint shader = glCreateShader(stage);
  const char* const text = assembly.text().c_str();
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  GLint compiled = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  const std::string log = compiled == GL_TRUE ? "" : info_log(shader, glGetShaderiv, glGetShaderInfoLog);
  glAttachShader(program, shader);
  glDeleteShader(shader);  // last: Emscripten forgets its name at once
  if (compiled == GL_TRUE) return;
  std::string message = "shader " + std::string(name) + " does not compile:\n" + log + "\nfile numbers:";
  for (std::size_t i = 0; i < assembly.names().size(); ++i) {
    message.append(" ").append(std::to_string(i)).append(" = ").append(assembly.names()[i]);
  }
  throw std::logic_error(message);
}

}  // namespace

Program::Program(std::string_view vertex_name, std::string_view fragment_name, std::span<const ShaderSource> files)
    : Program(vertex_name, {}, fragment_name, files) {}

Program::Program(std::string_view vertex_name, std::string_view geometry_name, std::string_view fragment_name,
                 std::span<const ShaderSource> files) {
  for (const auto& [stage, name] : {std::pair{GL_VERTEX_SHADER, vertex_name},
                                    {GL_GEOMETRY_SHADER, geometry_name},
                                    {GL_FRAGMENT_SHADER, fragment_name}}) {
    if (!name.empty()) add_shader(id(), GLenum(stage), name, files);
  }
  glLinkProgram(id());
  GLint linked = GL_FALSE;
  glGetProgramiv(id(), GL_LINK_STATUS, &linked);
  if (linked != GL_TRUE) {
    throw std::logic_error("shaders " + std::string(vertex_name) + " and " + std::string(fragment_name) +
                           " do not link:\n" + info_log(id(), glGetProgramiv, glGetProgramInfoLog));
  }
}

void Program::use() const { glUseProgram(id()); }

int Program::uniform(const char* name) const { return glGetUniformLocation(id(), name); }

}  // namespace litfog::gl
