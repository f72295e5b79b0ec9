// SPDX-License-Identifier: Apache-2.0
#include "litfog/gl/buffer_table.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <string>

#include "gl/upload_ranges.h"
#include "litfog/gl/unsupported.h"

namespace litfog::gl {

void expect_storage_buffers() {
  if (epoxy_gl_version() >= 43) return;
  for (const char* extension : {"GL_ARB_shader_storage_buffer_object", "GL_ARB_program_interface_query"}) {
    if (!epoxy_has_gl_extension(extension)) {
      throw Unsupported("this OpenGL has no storage buffers: it is older than 4.3 and lacks " + std::string(extension));
    }
  }
}

BufferTable::BufferTable(unsigned format, std::size_t texel_bytes, std::size_t entry_bytes)
    : format_(format), texel_bytes_(texel_bytes), entry_bytes_(entry_bytes) {
  if (!epoxy_is_desktop_gl()) throw Unsupported("OpenGL ES has no tables of lights: its shaders read 2-D textures");
  allocate(entry_bytes);  // because OpenGL has no empty buffer textures
}

void BufferTable::allocate(std::size_t bytes) {
  capacity_ = bytes;
  glBindBuffer(GL_TEXTURE_BUFFER, buffer_.id());
  glBufferData(GL_TEXTURE_BUFFER, GLsizeiptr(capacity_), nullptr, GL_DYNAMIC_DRAW);
  glBindTexture(GL_TEXTURE_BUFFER, texture_.id());
  glTexBuffer(GL_TEXTURE_BUFFER, format_, buffer_.id());
}

void BufferTable::upload(std::span<const std::byte> table, std::span<const EntryRange> changed) {
  const bool is_first = size_ == 0;
  const bool has_outgrown = table.size() > capacity_;
  // Grows by half, so that a table that grows light by light is rarely uploaded whole.
  if (has_outgrown) allocate(std::max(table.size(), capacity_ + capacity_ / 2));
  size_ = table.size();
  const EntryRange all{0, table.size() / entry_bytes_};
  glBindBuffer(GL_TEXTURE_BUFFER, buffer_.id());
  upload_ranges(GL_TEXTURE_BUFFER, 0, table, entry_bytes_, is_first || has_outgrown ? std::span(&all, 1) : changed);
}

void BufferTable::bind_texture(unsigned unit) const {
  GLint most = 0;
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
  const std::size_t texels = size_ / texel_bytes_;
  if (texels > std::size_t(most)) {
    throw Unsupported("the lights need a buffer texture of " + std::to_string(texels) +
                      " texels; this OpenGL has at most " + std::to_string(most));
  }
  glActiveTexture(GL_TEXTURE0 + unit);
  glBindTexture(GL_TEXTURE_BUFFER, texture_.id());
}

void BufferTable::bind_storage(unsigned binding) const {
  expect_storage_buffers();
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, buffer_.id());
}

}  // namespace litfog::gl
