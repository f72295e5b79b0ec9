// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "scene/file/gltf_file.h"
#include "scene/texels.h"

namespace litfog::scene {

/// Counts the texels of pictures up to 2^27, which take 512 MiB.
class TexelBudget {
 public:
  /// owner   what the picture is of
  /// throws  InputError at the owner of the picture that exceeds the limit
  void take(const JsonValue& owner, std::size_t texels);

 private:
  std::size_t texels_ = 0;
};

/// A decoded picture. Its texels are shared by all materials that use them unchanged; their A is 255.
class GltfPicture {
 public:
  explicit GltfPicture(Texels texels) : texels_(std::make_shared<const Texels>(std::move(texels))) {}

  const std::shared_ptr<const Texels>& texels() const { return texels_; }
  /// The mean of the texels' RGB as stored, in [0, 1], and of the linear colours that they are in sRGB.
  glm::vec3 mean();
  glm::vec3 linear_mean();

 private:
  std::shared_ptr<const Texels> texels_;
  std::optional<glm::vec3> mean_;
  std::optional<glm::vec3> linear_mean_;
};

/// The linear value, in [0, 1], of a level in sRGB.
float linear_value(std::uint8_t srgb_level);

/// The pictures of a glTF file's textures, PNG and JPEG, each decoded when it is first used, and once.
class GltfPictures {
 public:
  /// file  has to outlive this
  explicit GltfPictures(const GltfFile& file);

  /// The picture of a textureInfo, such as a material's "baseColorTexture". It stays where it is.
  ///
  /// throws  InputError
  GltfPicture& use(const JsonValue& texture_info);

 private:
  Texels read(const JsonValue& image);
  Texels decode(const JsonValue& image, std::string_view bytes);

  const GltfFile& file_;
  std::vector<JsonValue> textures_;
  std::vector<JsonValue> images_;
  std::map<std::size_t, GltfPicture> pictures_;  // by their image
  TexelBudget budget_;
};

}  // namespace litfog::scene
