// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

#include "litfog/gl/shader_library.h"

namespace litfog::gl {

/// A linked GL program of a vertex, perhaps a geometry, and a fragment shader.
class Program {
 public:
  /// Compiles two or three of the given files. A line `#include "name"` takes in a file of `files` or of
  /// shader_library(), each once; `#version 330 core` is put before. Compile errors name file and line.
  ///
  /// throws std::logic_error with the driver's log, for shaders are part of the program
  Program(std::string_view vertex_name, std::string_view fragment_name, std::span<const ShaderSource> files);
  /// geometry_name  empty: none
  Program(std::string_view vertex_name, std::string_view geometry_name, std::string_view fragment_name,
          std::span<const ShaderSource> files);
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  unsigned id() const { return id_; }
  void use() const;
  /// Location of a uniform; -1 (which GL ignores) where the compiler dropped it.
  int uniform(const char* name) const;

 private:
  unsigned id_ = 0;
};

}  // namespace litfog::gl
