// SPDX-License-Identifier: Apache-2.0
#include "render/gpu/texture.h"

#include <epoxy/gl.h>

#include <cassert>
#include <glm/gtc/type_ptr.hpp>

#include "render/gpu/texture_unit.h"

namespace litfog::render {
namespace {

using scene::Sampling;

GLint wrap_of(Sampling::Wrap wrap) {
  switch (wrap) {
    case Sampling::Wrap::repeat:
      return GL_REPEAT;
    case Sampling::Wrap::mirror:
      return GL_MIRRORED_REPEAT;
    default:
      return GL_CLAMP_TO_EDGE;
  }
}

GLint filter_of(Sampling::Filter filter) { return filter == Sampling::Filter::linear ? GL_LINEAR : GL_NEAREST; }

GLint filter_of(Sampling::Filter filter, Sampling::Mipmaps mipmaps) {
  const bool is_linear = filter == Sampling::Filter::linear;
  switch (mipmaps) {
    case Sampling::Mipmaps::linear:
      return is_linear ? GL_LINEAR_MIPMAP_LINEAR : GL_NEAREST_MIPMAP_LINEAR;
    case Sampling::Mipmaps::nearest:
      return is_linear ? GL_LINEAR_MIPMAP_NEAREST : GL_NEAREST_MIPMAP_NEAREST;
    default:
      return filter_of(filter);
  }
}

}  // namespace

Texture::Texture(const scene::Texels& texels, Encoding encoding) {
  assert(texels.rgba.size() == std::size_t(texels.width) * std::size_t(texels.height) * 4);
  bind_texture(kUploadUnit, name_);
  glTexImage2D(GL_TEXTURE_2D, 0, encoding == Encoding::srgb ? GL_SRGB8_ALPHA8 : GL_RGBA8, texels.width, texels.height,
               0, GL_RGBA, GL_UNSIGNED_BYTE, texels.rgba.data());
  glGenerateMipmap(GL_TEXTURE_2D);
  const Sampling& sampling = texels.sampling;
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap_of(sampling.wrap_u));
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap_of(sampling.wrap_v));
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER,
                  filter_of(sampling.minified, sampling.mipmaps));  // no anisotropic filtering: Mesa would take minutes
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter_of(sampling.magnified));
}

Texture::Texture(const glm::vec4& texel) {
  bind_texture(kUploadUnit, name_);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, 1, 1, 0, GL_RGBA, GL_FLOAT, glm::value_ptr(texel));
  set_filter(GL_TEXTURE_2D, GL_NEAREST);
}

void Texture::bind(unsigned unit) const { bind_texture(unit, name_); }

}  // namespace litfog::render
