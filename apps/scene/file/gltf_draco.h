// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string_view>

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
  /// name    as the primitive's
  /// format  its accessor's
  /// throws  InputError
  std::optional<GltfNumbers> attribute(std::string_view name, GltfNumbers format) const;
  /// Three a triangle.
  GltfNumbers indices() const;

 private:
  struct Mesh;

  JsonValue compression_;
  JsonValue attributes_;
  std::unique_ptr<const Mesh> mesh_;
};

}  // namespace litfog::scene
