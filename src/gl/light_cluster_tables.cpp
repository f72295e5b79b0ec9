// SPDX-License-Identifier: Apache-2.0
#include "litfog/gl/light_cluster_tables.h"

#include <epoxy/gl.h>

namespace litfog::gl {

LightClusterTables::LightClusterTables() : table_(GL_R32UI, sizeof(std::uint32_t), sizeof(std::uint32_t)) {}

void LightClusterTables::upload(const LightClusters& clusters) {
  const std::span<const std::uint32_t> table = clusters.table();
  const EntryRange all{0, table.size()};
  table_.upload(std::as_bytes(table), {&all, 1});
}

void LightClusterTables::bind_texture(const Program& program, unsigned unit) const {
  glUniform1i(program.uniform("litfog_cluster_buffer"), GLint(unit));
  bind_texture(unit);
}

}  // namespace litfog::gl
