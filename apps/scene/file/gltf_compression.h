// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "files/json_document.h"
#include "scene/file/gltf_file.h"

namespace litfog::scene {

/// A primitive's mesh that is compressed (KHR_draco_mesh_compression).
class GltfDraco {
 public:
  /// throws  InputError
  GltfDraco(const GltfFile& file, const JsonValue& compression);
  ~GltfDraco();

  /// An attribute, if it is compressed.
  ///
  /// name    as in the primitive
  /// format  the accessor's
  /// throws  InputError
  std::optional<GltfNumbers> attribute(std::string_view name, GltfNumbers format) const;
  /// Three indices per triangle.
  GltfNumbers indices() const;

 private:
  struct Mesh;

  JsonValue compression_;
  JsonValue attributes_;
  std::unique_ptr<const Mesh> mesh_;
};

using files::JsonValue;

inline constexpr std::string_view kMeshopt = "EXT_meshopt_compression";

/// Decodes a compressed buffer view.
///
/// compression  the view's extension
/// bytes        compressed
/// max_bytes    limit of decoded bytes
/// throws       InputError
std::string decode_meshopt(const JsonValue& compression, std::string_view bytes, std::size_t max_bytes);

}  // namespace litfog::scene
