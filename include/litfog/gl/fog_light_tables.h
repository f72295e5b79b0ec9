// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "litfog/fog_light_block.h"
#include "litfog/gl/buffer_table.h"
#include "litfog/gl/program.h"
#include "litfog/updater.h"

namespace litfog::gl {

/// A FogUpdater's tables, of any length, in two buffers that shaders read as buffer textures or as storage buffers
/// (litfog/shaders/light_buffer.glsl).
///
/// threads  like GlName
class FogLightTables {
 public:
  /// throws  Unsupported in a context of OpenGL ES, which has no buffer textures
  FogLightTables();

  /// Uploads the changed ranges; uploads a whole table the first time and when it outgrows its buffer, which changes
  /// the active texture unit's binding of GL_TEXTURE_BUFFER, so bind textures afterwards.
  void upload(std::span<const FogLightKind> kinds, std::span<const FogLightInstance> instances,
              const FogLightChanges& changes);

  /// Binds the tables as textures to texture units, for the samplers litfog_kind_buffer and litfog_instance_buffer.
  ///
  /// throws  Unsupported if a table has more texels than this OpenGL's buffer textures can hold
  void bind_textures(unsigned kind_unit, unsigned instance_unit) const;
  /// The same; also sets the program's samplers. The program must be in use.
  void bind_textures(const Program& program, unsigned kind_unit, unsigned instance_unit) const;

  /// Binds the tables as storage buffers to binding points: the shader's LITFOG_KIND_BINDING and
  /// LITFOG_INSTANCE_BINDING.
  ///
  /// throws  Unsupported where this OpenGL has no storage buffers
  void bind_storage(unsigned kind_binding, unsigned instance_binding) const;

 private:
  BufferTable kinds_;
  BufferTable instances_;
};

/// Compares the members' offsets in the program's LitfogKindBuffer and LitfogInstanceBuffer, as the driver laid them
/// out, with the C++ structs': all members of the first entry, and the stride between entries.
///
/// throws   Unsupported naming member, driver's offset and ours, or if this OpenGL has no storage buffers
/// threads  like GlName
void check_fog_light_storage_layout(const Program& program);

}  // namespace litfog::gl
