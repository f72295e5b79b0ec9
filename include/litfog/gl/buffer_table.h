// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "litfog/gl/gl_name.h"
#include "litfog/updater.h"

namespace litfog::gl {

/// A table in a growing buffer, which shaders read as a buffer texture or as a storage buffer.
///
/// threads  like GlName
class BufferTable {
 public:
  /// format  of the texels, e.g. GL_RGBA32F
  /// throws  Unsupported in a context of OpenGL ES, whose shaders read 2-D textures (LITFOG_LIGHT_TEXTURE)
  BufferTable(unsigned format, std::size_t texel_bytes, std::size_t entry_bytes);

  /// Uploads the changed entries; uploads the whole table the first time and when it outgrows its buffer, which changes
  /// the active texture unit's binding of GL_TEXTURE_BUFFER, so bind textures afterwards.
  void upload(std::span<const std::byte> table, std::span<const EntryRange> changed);

  /// Binds the table as a texture to a texture unit.
  ///
  /// throws  Unsupported if it has more texels than this OpenGL's buffer textures can hold
  void bind_texture(unsigned unit) const;

  /// Binds the table as a storage buffer to a binding point.
  ///
  /// throws  Unsupported if this OpenGL has no storage buffers
  void bind_storage(unsigned binding) const;

 private:
  void allocate(std::size_t bytes);

  unsigned format_;
  std::size_t texel_bytes_;
  std::size_t entry_bytes_;
  std::size_t size_ = 0;  // bytes
  std::size_t capacity_ = 0;
  BufferName buffer_;
  TextureName texture_;
};

/// throws   Unsupported if this OpenGL has no storage buffers
void expect_storage_buffers();

}  // namespace litfog::gl
