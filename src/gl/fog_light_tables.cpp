// SPDX-License-Identifier: Apache-2.0
#include "litfog/gl/fog_light_tables.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <string>

#include "gl/upload_ranges.h"
#include "litfog/gl/unsupported.h"

namespace litfog::gl {
namespace {

void expect_storage_buffers() {
  if (epoxy_gl_version() >= 43) return;
  for (const char* extension : {"GL_ARB_shader_storage_buffer_object", "GL_ARB_program_interface_query"}) {
    if (!epoxy_has_gl_extension(extension)) {
      throw Unsupported("this OpenGL has no storage buffers: it is older than 4.3 and lacks " + std::string(extension));
    }
  }
}

}  // namespace

FogLightTables::Table::Table(std::size_t entry_bytes) : entry_bytes_(entry_bytes) {
  allocate(entry_bytes);  // because OpenGL has no empty buffer textures
}

void FogLightTables::Table::allocate(std::size_t bytes) {
  capacity_ = bytes;
  glBindBuffer(GL_TEXTURE_BUFFER, buffer_.id());
  glBufferData(GL_TEXTURE_BUFFER, GLsizeiptr(capacity_), nullptr, GL_DYNAMIC_DRAW);
  glBindTexture(GL_TEXTURE_BUFFER, texture_.id());
  glTexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, buffer_.id());
}

void FogLightTables::Table::upload(std::span<const std::byte> table, std::span<const EntryRange> changed) {
  const bool is_first = size_ == 0;
  const bool has_outgrown = table.size() > capacity_;
  // By half at a time, so that a table that grows light by light is rarely uploaded whole.
  if (has_outgrown) allocate(std::max(table.size(), capacity_ + capacity_ / 2));
  size_ = table.size();
  const EntryRange all{0, table.size() / entry_bytes_};
  glBindBuffer(GL_TEXTURE_BUFFER, buffer_.id());
  upload_ranges(GL_TEXTURE_BUFFER, 0, table, entry_bytes_, is_first || has_outgrown ? std::span(&all, 1) : changed);
}

void FogLightTables::Table::bind_texture(unsigned unit) const {
  GLint most = 0;
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
  const std::size_t texels = size_ / sizeof(glm::vec4);
  if (texels > std::size_t(most)) {
    throw Unsupported("the lights need a buffer texture of " + std::to_string(texels) +
                      " texels; this OpenGL has at most " + std::to_string(most));
  }
  glActiveTexture(GL_TEXTURE0 + unit);
  glBindTexture(GL_TEXTURE_BUFFER, texture_.id());
}

void FogLightTables::Table::bind_storage(unsigned binding) const {
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, buffer_.id());
}

void FogLightTables::upload(std::span<const FogLightKind> kinds, std::span<const FogLightInstance> instances,
                            const FogLightChanges& changes) {
  kinds_.upload(std::as_bytes(kinds), changes.kinds);
  instances_.upload(std::as_bytes(instances), changes.instances);
}

void FogLightTables::bind_textures(unsigned kind_unit, unsigned instance_unit) const {
  kinds_.bind_texture(kind_unit);
  instances_.bind_texture(instance_unit);
}

void FogLightTables::bind_storage(unsigned kind_binding, unsigned instance_binding) const {
  expect_storage_buffers();
  kinds_.bind_storage(kind_binding);
  instances_.bind_storage(instance_binding);
}

void check_fog_light_storage_layout(const Program& program) {
  expect_storage_buffers();
  const auto check = [&](const std::string& table, const std::string& member, std::size_t offset, std::size_t stride) {
    const std::string name = table + "[0]." + member;
    const GLuint index = glGetProgramResourceIndex(program.id(), GL_BUFFER_VARIABLE, name.c_str());
    constexpr std::array<GLenum, 2> kProperties{GL_OFFSET, GL_TOP_LEVEL_ARRAY_STRIDE};
    std::array<GLint, 2> values{-1, -1};
    if (index != GL_INVALID_INDEX) {
      glGetProgramResourceiv(program.id(), GL_BUFFER_VARIABLE, index, GLsizei(kProperties.size()), kProperties.data(),
                             GLsizei(values.size()), nullptr, values.data());
    }
    if (values != std::array{GLint(offset), GLint(stride)}) {
      throw Unsupported("the driver puts " + name + " at byte " + std::to_string(values[0]) + ", entries " +
                        std::to_string(values[1]) + " bytes apart; std430 has it at " + std::to_string(offset) + ", " +
                        std::to_string(stride) + " apart");
    }
  };
  const std::string kinds = "litfog_kind_buffer";
  check(kinds, "attenuation_extent", offsetof(FogLightKind, attenuation_extent), sizeof(FogLightKind));
  check(kinds, "cone_scale_intensity", offsetof(FogLightKind, cone_scale_intensity), sizeof(FogLightKind));
  const std::string instances = "litfog_instance_buffer";
  check(instances, "position_kind", offsetof(FogLightInstance, position_kind), sizeof(FogLightInstance));
  check(instances, "axis_profile", offsetof(FogLightInstance, axis_profile), sizeof(FogLightInstance));
  check(instances, "color", offsetof(FogLightInstance, color), sizeof(FogLightInstance));
}

}  // namespace litfog::gl
