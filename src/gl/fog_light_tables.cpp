// SPDX-License-Identifier: Apache-2.0
#include "litfog/gl/fog_light_tables.h"

#include <epoxy/gl.h>

#include <array>
#include <cstddef>
#include <string>

#include "litfog/gl/unsupported.h"

namespace litfog::gl {
FogLightTables::FogLightTables()
    : kinds_(GL_RGBA32F, sizeof(glm::vec4), sizeof(FogLightKind)),
      instances_(GL_RGBA32F, sizeof(glm::vec4), sizeof(FogLightInstance)) {}

void FogLightTables::upload(std::span<const FogLightKind> kinds, std::span<const FogLightInstance> instances,
                            const FogLightChanges& changes) {
  kinds_.upload(std::as_bytes(kinds), changes.kinds);
  instances_.upload(std::as_bytes(instances), changes.instances);
}

void FogLightTables::bind_textures(unsigned kind_unit, unsigned instance_unit) const {
  kinds_.bind_texture(kind_unit);
  instances_.bind_texture(instance_unit);
}

void FogLightTables::bind_textures(const Program& program, unsigned kind_unit, unsigned instance_unit) const {
  glUniform1i(program.uniform("litfog_kind_buffer"), GLint(kind_unit));
  glUniform1i(program.uniform("litfog_instance_buffer"), GLint(instance_unit));
  bind_textures(kind_unit, instance_unit);
}

void FogLightTables::bind_storage(unsigned kind_binding, unsigned instance_binding) const {
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
