// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "litfog/gl/gl_name.h"

namespace litfog::render {

// Textures that hold data for shaders, not pictures.

/// A map of 16-bit fractions with linear filtering, clamped at its edges: no repetition, no mipmaps.
class LookupTexture {
 public:
  enum class Shape { line, square, volume, cube };

  /// texels  size^dimensions values, or six faces of a cube: +x -x +y -y +z -z
  /// throws  gl::Unsupported where this OpenGL has no texture of that size
  LookupTexture(Shape shape, int size, const std::vector<std::uint16_t>& texels);

  void bind(unsigned unit) const;

 private:
  unsigned target_;
  gl::TextureName name_;
};

/// An array of square pictures of 16-bit fractions with linear filtering inside each.
class LayeredTexture {
 public:
  /// texels  size * size * layers
  /// throws  gl::Unsupported if the driver's layer or size limit is exceeded
  LayeredTexture(int size, int layers, const std::vector<std::uint16_t>& texels);

  void bind(unsigned unit) const;

 private:
  gl::TextureName name_;
};

/// A buffer of texels for a shader's texelFetch: four floats or one integer each.
class BufferTexture {
 public:
  enum class Texel { float4, int1 };

  /// The largest number of texels in a buffer texture of the current context.
  static std::size_t max_texels();

  /// throws gl::Unsupported where the data have more than max_texels()
  BufferTexture(const void* data, std::size_t bytes, Texel texel);

  void bind(unsigned unit) const;

 private:
  gl::BufferName buffer_;
  gl::TextureName texture_;
};

}  // namespace litfog::render
