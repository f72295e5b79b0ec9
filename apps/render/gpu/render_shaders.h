// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "litfog/gl/shader_library.h"

namespace litfog::render {

/// The files of apps/render/shaders, embedded.
std::span<const gl::ShaderSource> render_shaders();

/// render_shaders() for a scene with or without cookies and lamp shadows.
inline std::vector<gl::ShaderSource> scene_shaders(bool has_cookies, bool has_shadows = false) {
  std::vector<gl::ShaderSource> files;
  if (has_shadows) files.push_back({"shadow/shadow.glsl", "#include \"shadow/mapped_shadow.glsl\"\n"});
  if (has_shadows) files.push_back({"airlight/shaft.glsl", "#include \"airlight/mapped_shaft.glsl\"\n"});
  if (has_cookies) files.push_back({"cookie.glsl", "#include \"cube_cookie.glsl\"\n"});  // found before the file
  files.insert(files.end(), render_shaders().begin(), render_shaders().end());
  return files;
}

}  // namespace litfog::render
