// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "scene/file/gltf_file.h"
#include "scene/file/gltf_picture.h"
#include "scene/material.h"

namespace litfog::scene {

/// A used material of a glTF file.
struct GltfMaterial {
  std::string name;
  bool is_double_sided;
  std::set<std::size_t> sets;  ///< sets of texture coordinates that its textures use
  GltfCoordinates base;        ///< the base texture's or, without one, another's
  GltfCoordinates normal;      ///< the normal map's or, without one, the base's
  GltfCoordinates emission;    ///< the emission texture's or, without one, the base's
};

/// Converts the used materials of a glTF file as read_gltf_scene documents.
class GltfMaterials {
 public:
  /// file  must outlive this object
  explicit GltfMaterials(const GltfFile& file);

  /// A primitive's material, converted on first use.
  ///
  /// throws  InputError
  const GltfMaterial& use(const JsonValue& primitive);

  /// The converted materials.
  std::vector<Material> take() { return std::move(materials_); }

  std::size_t occluded() const { return occluded_; }  ///< number of materials with an occlusion texture
  /// The extensions of the materials, known or not: files do not always list them in "extensionsUsed".
  const std::set<std::string>& extensions() const { return extensions_; }

 private:
  using SharedTexels = std::shared_ptr<const Texels>;

  Material make_lit(const std::string& name, const JsonValue& given, const JsonValue& pbr);
  Material make_unlit(const std::string& name, const JsonValue& given, const JsonValue& pbr);
  /// The texels of a base texture or of its replacement.
  SharedTexels base_texels(const JsonValue& material, const std::optional<JsonValue>& texture, bool is_masked);
  /// The metallic value per texel: a factor times the blue of a picture. Null: none.
  struct Metal {
    SharedTexels texels = nullptr;
    float factor;
  };
  /// A picture whose colours are multiplied by a factor and by 1 - metallic.
  SharedTexels tinted(const JsonValue& material, const SharedTexels& picture, const glm::vec3& factor,
                      const Metal& metal);

  JsonValue empty_;  // an empty object: glTF's default material, and a material's default model
  std::vector<JsonValue> given_;
  std::vector<std::optional<GltfMaterial>> used_;  // one per material of the file, then the default
  std::vector<Material> materials_;
  GltfPictures pictures_;
  GltfPicture white_;
  SharedTexels flat_;  // a normal map
  // Pictures derived from the file's, shared if equal.
  std::map<std::tuple<const Texels*, const Texels*, std::array<float, 4>>, SharedTexels> tinted_;
  TexelBudget made_;
  std::size_t occluded_ = 0;
  std::set<std::string> extensions_;
};

}  // namespace litfog::scene
