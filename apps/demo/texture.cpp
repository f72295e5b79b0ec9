// SPDX-License-Identifier: Apache-2.0
#include "texture.h"

#include <epoxy/gl.h>

#include <array>
#include <cassert>
#include <string>
#include <utility>

#include "litfog/gl/unsupported.h"

namespace litfog::demo {

Texture::Texture(int size, const std::vector<std::uint8_t>& texels, Encoding encoding) {
  assert(texels.size() == std::size_t(size) * std::size_t(size) * 4);
  glGenTextures(1, &id_);
  glBindTexture(GL_TEXTURE_2D, id_);
  glTexImage2D(GL_TEXTURE_2D, 0, encoding == Encoding::srgb ? GL_SRGB8_ALPHA8 : GL_RGBA8, size, size, 0, GL_RGBA,
               GL_UNSIGNED_BYTE, texels.data());
  glGenerateMipmap(GL_TEXTURE_2D);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER,
                  GL_LINEAR_MIPMAP_LINEAR);  // no anisotropy: Mesa's rasteriser takes minutes over it
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
}

Texture::~Texture() { glDeleteTextures(1, &id_); }

Texture::Texture(Texture&& other) noexcept : id_(std::exchange(other.id_, 0)) {}

void Texture::bind(unsigned unit) const {
  glActiveTexture(GL_TEXTURE0 + unit);
  glBindTexture(GL_TEXTURE_2D, id_);
}

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
  glGenBuffers(1, &buffer_);
  glBindBuffer(GL_TEXTURE_BUFFER, buffer_);
  glBufferData(GL_TEXTURE_BUFFER, GLsizeiptr(bytes > 0 ? bytes : kOneTexel.size()), bytes > 0 ? data : kOneTexel.data(),
               GL_STATIC_DRAW);
  glGenTextures(1, &texture_);
  glBindTexture(GL_TEXTURE_BUFFER, texture_);
  glTexBuffer(GL_TEXTURE_BUFFER, texel == Texel::float4 ? GL_RGBA32F : GL_R32I, buffer_);
}

BufferTexture::~BufferTexture() {
  glDeleteTextures(1, &texture_);
  glDeleteBuffers(1, &buffer_);
}

void BufferTexture::bind(unsigned unit) const {
  glActiveTexture(GL_TEXTURE0 + unit);
  glBindTexture(GL_TEXTURE_BUFFER, texture_);
}

}  // namespace litfog::demo
