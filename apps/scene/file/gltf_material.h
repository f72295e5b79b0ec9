// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "scene/file/gltf_file.h"
#include "scene/file/gltf_picture.h"
#include "scene/material.h"

namespace litfog::scene {

/// A material of a glTF file that is used.
struct GltfMaterial {
  std::size_t index;  ///< of those made, in their order
  std::string name;
  bool is_double_sided;
};

/// Converts the materials of a glTF file that are used to the demo's; read_gltf_scene documents how.
class GltfMaterials {
 public:
  /// file  has to outlive this
  explicit GltfMaterials(const GltfFile& file);

  /// A primitive's material, which is made when first used.
  ///
  /// throws  InputError
  const GltfMaterial& use(const JsonValue& primitive);

  /// Those made.
  std::vector<Material> take() { return std::move(materials_); }

 private:
  using SharedTexels = std::shared_ptr<const Texels>;

  Material make(const std::string& name, const JsonValue& given);
  /// A picture whose colours are multiplied by a factor.
  SharedTexels tinted(const JsonValue& material, const SharedTexels& picture, const glm::vec3& factor);
  SharedTexels normal_map(const JsonValue& material);

  JsonValue empty_;  // an object: glTF's default material, and a material's default model
  std::vector<JsonValue> given_;
  std::vector<std::optional<GltfMaterial>> used_;  // of those given, then the default
  std::vector<Material> materials_;
  GltfPictures pictures_;
  GltfPicture white_;
  SharedTexels flat_;  // a normal map
  // Pictures derived from the file's, shared where they are the same.
  std::map<std::pair<const Texels*, std::array<float, 3>>, SharedTexels> tinted_;
  std::map<std::pair<const Texels*, float>, SharedTexels> scaled_normals_;
  TexelBudget made_;
};

}  // namespace litfog::scene
