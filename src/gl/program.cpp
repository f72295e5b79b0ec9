// SPDX-License-Identifier: Apache-2.0
#include "litfog/gl/program.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

namespace litfog::gl {
namespace {

/// Puts a shader together from its files; `#line` keeps each file's own line numbers, by the file's index in names().
class Assembly {
 public:
  explicit Assembly(std::span<const ShaderSource> files) : files_(files) {}

  std::string assemble(std::string_view name) {
    text_ = "#version 330 core\n";
    add(name);
    return text_;
  }
  const std::vector<std::string_view>& names() const { return names_; }

 private:
  const ShaderSource& find(std::string_view name) const {
    for (std::span<const ShaderSource> files : {files_, shader_library()}) {
      const auto found = std::ranges::find(files, name, &ShaderSource::name);
      if (found != files.end()) return *found;
    }
    throw std::logic_error("no shader file " + std::string(name));
  }

  void add(std::string_view name) {
    if (std::ranges::find(names_, name) != names_.end()) return;
    const std::size_t file = names_.size();
    names_.push_back(name);
    const auto begin_at = [&](std::size_t line) {
      text_ += "#line " + std::to_string(line) + " " + std::to_string(file) + "\n";
    };
    begin_at(1);
    std::string_view rest = find(name).text;
    for (std::size_t line = 1; !rest.empty(); ++line) {
      const std::string_view text = rest.substr(0, rest.find('\n'));
      rest.remove_prefix(std::min(text.size() + 1, rest.size()));
      constexpr std::string_view kInclude = "#include \"";
      if (text.starts_with(kInclude)) {
        const std::string_view included = text.substr(kInclude.size());
        add(included.substr(0, included.find('"')));
        begin_at(line + 1);
      } else {
        text_.append(text).append("\n");
      }
    }
  }

  std::span<const ShaderSource> files_;
  std::vector<std::string_view> names_;
  std::string text_;
};

/// The driver's log, read by a glGet*iv and a glGet*InfoLog.
template <typename GetParameter, typename GetLog>
std::string info_log(GLuint object, GetParameter get_parameter, GetLog get_log) {
  GLint length = 0;
  get_parameter(object, GL_INFO_LOG_LENGTH, &length);
  std::string log(std::size_t(std::max(length, 1)), '\0');
  get_log(object, GLsizei(log.size()), &length, log.data());
  log.resize(std::size_t(length));  // without the terminator, where an exception's text would end
  return log;
}

/// Compiles a shader into a program, with which it is deleted.
void add_shader(GLuint program, GLenum stage, std::string_view name, std::span<const ShaderSource> files) {
  Assembly assembly(files);
  const std::string text = assembly.assemble(name);
  const GLuint shader = glCreateShader(stage);
  glAttachShader(program, shader);
  glDeleteShader(shader);
  const char* const pointer = text.c_str();
  glShaderSource(shader, 1, &pointer, nullptr);
  glCompileShader(shader);
  GLint compiled = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  if (compiled == GL_TRUE) return;
  std::string message = "shader " + std::string(name) + " does not compile:\n" +
                        info_log(shader, glGetShaderiv, glGetShaderInfoLog) + "\nfile numbers:";
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
