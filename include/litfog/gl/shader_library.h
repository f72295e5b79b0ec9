// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

namespace litfog::gl {

/// A shader file: its text, and the name by which other files include it.
struct ShaderSource {
  std::string_view name;  ///< e.g. "litfog/shaders/fog.glsl"
  std::string_view text;
};

/// litfog's own shader files, as installed, embedded in the library.
///
/// threads  any
std::span<const ShaderSource> shader_library();

}  // namespace litfog::gl
