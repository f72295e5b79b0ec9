// SPDX-License-Identifier: Apache-2.0
#include "litfog/gl/fog_light_buffer.h"

#include <epoxy/gl.h>

#include <cstddef>
#include <string>

#include "gl/upload_ranges.h"
#include "litfog/gl/unsupported.h"
#include "model/require.h"
#include "tables/fog_light_count.h"

namespace litfog::gl {

FogLightBuffer::FogLightBuffer() {
  glBindBuffer(GL_UNIFORM_BUFFER, name_.id());
  glBufferData(GL_UNIFORM_BUFFER, sizeof(FogLightBlock), nullptr, GL_DYNAMIC_DRAW);
}

void FogLightBuffer::upload(const FogLightBlock& block) {
  glBindBuffer(GL_UNIFORM_BUFFER, name_.id());
  glBufferSubData(GL_UNIFORM_BUFFER, 0, sizeof(block), &block);
  has_tables_ = false;  // a FogUpdater's tables are gone
}

void FogLightBuffer::upload(const FogHeader& header) {
  glBindBuffer(GL_UNIFORM_BUFFER, name_.id());
  glBufferSubData(GL_UNIFORM_BUFFER, offsetof(FogLightBlock, header), sizeof(header), &header);
}

void FogLightBuffer::upload(const FogHeader& header, std::span<const FogLightKind> kinds,
                            std::span<const FogLightInstance> instances, const FogLightChanges& changes) {
  require_fog_light_count("kinds", kinds.size());
  require_fog_light_count("instances", instances.size());
  upload(header);
  const auto upload_table = [&](std::size_t offset, const auto& table, std::span<const EntryRange> changed) {
    const EntryRange all{0, table.size()};
    upload_ranges(GL_UNIFORM_BUFFER, offset, std::as_bytes(table), sizeof(table[0]),
                  has_tables_ ? changed : std::span(&all, 1));
  };
  upload_table(offsetof(FogLightBlock, kinds), kinds, changes.kinds);
  upload_table(offsetof(FogLightBlock, instances), instances, changes.instances);
  has_tables_ = true;
}

void FogLightBuffer::bind(const Program& program, unsigned binding) const {
  const GLuint index = glGetUniformBlockIndex(program.id(), "LitfogLightBlock");
  if (index != GL_INVALID_INDEX) glUniformBlockBinding(program.id(), index, binding);
  glBindBufferBase(GL_UNIFORM_BUFFER, binding, name_.id());
}

void check_fog_light_layout(const Program& program) {
  const auto check = [&](const std::string& name, std::size_t expected) {
    const char* const pointer = name.c_str();
    GLuint index = GL_INVALID_INDEX;
    glGetUniformIndices(program.id(), 1, &pointer, &index);
    GLint offset = -1;
    if (index != GL_INVALID_INDEX) glGetActiveUniformsiv(program.id(), 1, &index, GL_UNIFORM_OFFSET, &offset);
    if (offset != GLint(expected)) {
      throw Unsupported("LitfogLightBlock: the driver puts " + name + " at byte " + std::to_string(offset) +
                        ", std140 has it at " + std::to_string(expected));
    }
  };
  check("litfog_fog", offsetof(FogHeader, fog));
  check("litfog_ambient_fog_color", offsetof(FogHeader, ambient_fog_color));
  check("litfog_phase_lobes[0]", offsetof(FogHeader, phase_lobes));
  check("litfog_density_knots[0]", offsetof(FogHeader, density_knots));
  for (const std::size_t i : {std::size_t{0}, std::size_t{1}, kMaxFogLights - 1}) {
    const std::string kind = "litfog_kinds[" + std::to_string(i) + "].";
    const std::size_t kind_base = offsetof(FogLightBlock, kinds) + i * sizeof(FogLightKind);
    check(kind + "attenuation_extent", kind_base + offsetof(FogLightKind, attenuation_extent));
    check(kind + "cone_scale_intensity", kind_base + offsetof(FogLightKind, cone_scale_intensity));
    const std::string instance = "litfog_instances[" + std::to_string(i) + "].";
    const std::size_t instance_base = offsetof(FogLightBlock, instances) + i * sizeof(FogLightInstance);
    check(instance + "position_kind", instance_base + offsetof(FogLightInstance, position_kind));
    check(instance + "axis_profile", instance_base + offsetof(FogLightInstance, axis_profile));
    check(instance + "color", instance_base + offsetof(FogLightInstance, color));
  }
}

}  // namespace litfog::gl
