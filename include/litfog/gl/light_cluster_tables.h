// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "litfog/gl/buffer_table.h"
#include "litfog/gl/program.h"
#include "litfog/light_clusters.h"

namespace litfog::gl {

/// The table of LightClusters in a buffer (litfog/shaders/light_clusters.glsl).
///
/// threads  like GlName
class LightClusterTables {
 public:
  /// throws  Unsupported in a context of OpenGL ES, which has no buffer textures
  LightClusterTables();

  /// Uploads the table. Needed if LightClusters::update() says that it has changed. Bind the texture afterwards.
  void upload(const LightClusters& clusters);

  /// Binds the table as a texture to a texture unit, for the sampler litfog_cluster_buffer.
  ///
  /// throws  Unsupported if it has more texels than this OpenGL's buffer textures can hold
  void bind_texture(unsigned unit) const { table_.bind_texture(unit); }
  /// The same; also sets the program's sampler. The program must be in use.
  void bind_texture(const Program& program, unsigned unit) const;

  /// Binds the table as a storage buffer to a binding point: the shader's LITFOG_CLUSTER_BINDING.
  ///
  /// throws  Unsupported if this OpenGL has no storage buffers
  void bind_storage(unsigned binding) const { table_.bind_storage(binding); }

 private:
  BufferTable table_;
};

}  // namespace litfog::gl
