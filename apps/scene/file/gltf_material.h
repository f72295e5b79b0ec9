// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "scene/file/gltf_file.h"
#include "scene/material.h"

namespace litfog::scene {

/// Makes the demo's materials of those of a glTF file that are used (read_gltf_scene tells how).
class GltfMaterials {
 public:
  /// file  has to outlive this
  explicit GltfMaterials(const GltfFile& file) : file_(file), is_used_(file.model().materials.size() + 1) {}

  /// The name of a material, which is made when first used. Its pictures have at most 2^27 pixels together with those
  /// made before.
  ///
  /// place   of the number
  /// number  -1: glTF's default material
  /// throws  InputError
  std::string use(const GltfPlace& place, int number);

  /// Those made.
  std::vector<Material> take() { return std::move(materials_); }

 private:
  Material make(const std::string& name, const GltfPlace& place, const tinygltf::Material& given);
  glm::vec3 color_of(const GltfPlace& place, const std::vector<double>& given, std::size_t size) const;
  float share_of(const GltfPlace& place, double given) const;
  Texels normal_map(const GltfPlace& place, const tinygltf::NormalTextureInfo& given);
  /// A texture's picture, or one texel where there is none.
  Texels texture(const GltfPlace& place, const tinygltf::TextureInfo& info, const std::array<std::uint8_t, 3>& absent);
  Texels decode(const GltfPlace& place, std::span<const unsigned char> bytes);

  const GltfFile& file_;
  std::vector<bool> is_used_;
  std::vector<Material> materials_;
  std::size_t texels_ = 0;
};

}  // namespace litfog::scene
