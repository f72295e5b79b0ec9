// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include "litfog/gl/gl_name.h"
#include "scene/texels.h"

namespace litfog::render {

/// A mipmapped RGBA8 texture with the sampling that its texels state.
class Texture {
 public:
  enum class Encoding { linear, srgb };

  Texture(const scene::Texels& texels, Encoding encoding);
  /// One texel of floats, linear.
  explicit Texture(const glm::vec4& texel);

  void bind(unsigned unit) const;

 private:
  gl::TextureName name_;
};

}  // namespace litfog::render
