// SPDX-License-Identifier: Apache-2.0
#include "render/gpu/data_texture.h"

#include <epoxy/gl.h>

#include <array>
#include <cassert>
#include <string>

#include "litfog/gl/unsupported.h"
#include "render/gpu/texture_unit.h"

namespace litfog::render {

LookupTexture::LookupTexture(Shape shape, int size, const std::vector<std::uint16_t>& texels) {
  struct Kind {
    GLenum target;
    GLenum limit;
    std::size_t texels;
  };
  const auto n = std::size_t(size);
  const std::array<Kind, 4> kinds{{{GL_TEXTURE_1D, GL_MAX_TEXTURE_SIZE, n},
                                   {GL_TEXTURE_2D, GL_MAX_TEXTURE_SIZE, n * n},
                                   {GL_TEXTURE_3D, GL_MAX_3D_TEXTURE_SIZE, n * n * n},
                                   {GL_TEXTURE_CUBE_MAP, GL_MAX_CUBE_MAP_TEXTURE_SIZE, 6 * n * n}}};
  const Kind& kind = kinds[std::size_t(shape)];
  assert(texels.size() == kind.texels);
  GLint largest = 0;
  glGetIntegerv(kind.limit, &largest);
  if (size > largest) {
    throw gl::Unsupported("a light map of " + std::to_string(size) + " texels a side is too large: this OpenGL has " +
                          std::to_string(largest));
  }
  target_ = kind.target;
  bind_texture(kUploadUnit, name_, target_);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 2);
  switch (shape) {
    case Shape::line:
      glTexImage1D(target_, 0, GL_R16, size, 0, GL_RED, GL_UNSIGNED_SHORT, texels.data());
      break;
    case Shape::square:
      glTexImage2D(target_, 0, GL_R16, size, size, 0, GL_RED, GL_UNSIGNED_SHORT, texels.data());
      break;
    case Shape::volume:
      glTexImage3D(target_, 0, GL_R16, size, size, size, 0, GL_RED, GL_UNSIGNED_SHORT, texels.data());
      break;
    case Shape::cube:
      for (std::size_t face = 0; face < 6; ++face) {
        glTexImage2D(GLenum(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face), 0, GL_R16, size, size, 0, GL_RED, GL_UNSIGNED_SHORT,
                     &texels[face * n * n]);
      }
      break;
  }
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  interpolate_within_edges(target_);
}

void LookupTexture::bind(unsigned unit) const { bind_texture(unit, name_, target_); }

LayeredTexture::LayeredTexture(int size, int layers, const std::vector<std::uint16_t>& texels) {
  assert(texels.size() == std::size_t(size) * std::size_t(size) * std::size_t(layers));
  GLint most = 0;
  GLint largest = 0;
  glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &most);
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  if (layers > most || size > largest) {
    throw gl::Unsupported("the scene's cookies need " + std::to_string(layers) + " layers of " + std::to_string(size) +
                          " texels a side; this OpenGL has " + std::to_string(most) + " of " + std::to_string(largest));
  }
  bind_texture(kUploadUnit, name_, GL_TEXTURE_2D_ARRAY);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 2);
  glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_R16, size, size, layers, 0, GL_RED, GL_UNSIGNED_SHORT, texels.data());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  interpolate_within_edges(GL_TEXTURE_2D_ARRAY);
}

void LayeredTexture::bind(unsigned unit) const { bind_texture(unit, name_, GL_TEXTURE_2D_ARRAY); }

std::size_t BufferTexture::max_texels() {
  GLint most = 0;
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
  return std::size_t(most);
}

BufferTexture::BufferTexture(const void* data, std::size_t bytes, Texel texel) {
  const std::size_t texels = bytes / (texel == Texel::float4 ? 4 * sizeof(float) : sizeof(std::int32_t));
  if (texels > max_texels()) {
    throw gl::Unsupported("the scene's lights need a buffer texture of " + std::to_string(texels) +
                          " texels; this OpenGL has at most " + std::to_string(max_texels()));
  }
  constexpr std::array<char, 16> kOneTexel{};  // GL has no empty buffer textures
  glBindBuffer(GL_TEXTURE_BUFFER, buffer_.id());
  glBufferData(GL_TEXTURE_BUFFER, GLsizeiptr(bytes > 0 ? bytes : kOneTexel.size()), bytes > 0 ? data : kOneTexel.data(),
               GL_STATIC_DRAW);
  bind_texture(kUploadUnit, texture_, GL_TEXTURE_BUFFER);
  glTexBuffer(GL_TEXTURE_BUFFER, texel == Texel::float4 ? GL_RGBA32F : GL_R32I, buffer_.id());
}

void BufferTexture::bind(unsigned unit) const { bind_texture(unit, texture_, GL_TEXTURE_BUFFER); }

}  // namespace litfog::render
