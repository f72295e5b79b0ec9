// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

#include "litfog/gl/gl_name.h"
#include "litfog/gl/shader_library.h"

namespace litfog::gl {

/// A linked GL program of a vertex, perhaps a geometry, and a fragment shader.
///
/// threads  like GlName
class Program {
 public:
  /// Compiles two or three of the given files behind `#version 330 core`, or `#version 300 es` in a context of
  /// OpenGL ES or WebGL 2. A line `#include "name"` includes a file of `files`, otherwise of shader_library(), and each
  /// file only once. Compile errors name file and line.
  ///
  /// throws  std::logic_error with the driver's log, because shaders are part of the program
  Program(std::string_view vertex_name, std::string_view fragment_name, std::span<const ShaderSource> files);
  /// geometry_name  empty: none
  Program(std::string_view vertex_name, std::string_view geometry_name, std::string_view fragment_name,
          std::span<const ShaderSource> files);

  unsigned id() const { return name_.id(); }
  void use() const;
  /// Location of a uniform; -1 (which GL ignores) if the compiler dropped it.
  int uniform(const char* name) const;

 private:
  ProgramName name_;
};

}  // namespace litfog::gl
