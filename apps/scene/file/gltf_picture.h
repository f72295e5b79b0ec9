// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "image/image_library.h"
#include "scene/file/gltf_file.h"
#include "scene/texels.h"

namespace litfog::scene {

/// Counts the texels of pictures up to 2^27, which take 512 MiB.
class TexelBudget {
 public:
  /// owner   the value that uses the picture
  /// throws  InputError at the owner of the picture that exceeds the limit
  void take(const JsonValue& owner, std::size_t texels);

 private:
  std::size_t texels_ = 0;
};

/// A decoded picture. Its texels are shared by all materials that use them unchanged; their A is 255.
class GltfPicture {
 public:
  /// alpha  one per texel; empty: 255
  explicit GltfPicture(Texels texels, std::vector<std::uint8_t> alpha = {})
      : texels_(std::make_shared<const Texels>(std::move(texels))), alpha_(std::move(alpha)) {}

  /// This picture with another sampling.
  GltfPicture sampled(const Sampling& sampling) const;

  const std::shared_ptr<const Texels>& texels() const { return texels_; }
  /// The texels with the picture's alpha as A, counted on first use.
  ///
  /// owner   the value that uses the picture, for the error's location
  /// throws  InputError
  const std::shared_ptr<const Texels>& covering_texels(const JsonValue& owner, TexelBudget& budget);
  /// The mean of the texels' RGB as stored, in [0, 1], and after conversion from sRGB to linear.
  glm::vec3 mean();
  glm::vec3 linear_mean();

 private:
  std::shared_ptr<const Texels> texels_;
  std::vector<std::uint8_t> alpha_;
  std::shared_ptr<const Texels> covering_;
  std::optional<glm::vec3> mean_;
  std::optional<glm::vec3> linear_mean_;
};

/// The linear value, in [0, 1], of an sRGB level.
float linear_value(std::uint8_t srgb_level);

/// The texture coordinates of a textureInfo: a set, transformed (KHR_texture_transform).
struct GltfCoordinates {
  std::size_t set = 0;
  glm::mat3x2 transform{1};  ///< applied to (u, v, 1)

  bool operator==(const GltfCoordinates&) const = default;
};

/// throws  InputError
GltfCoordinates coordinates_of(const JsonValue& texture_info);

/// The pictures of a glTF file's textures, PNG, JPEG and WebP, each decoded once, on first use.
class GltfPictures {
 public:
  /// file  must outlive this object
  explicit GltfPictures(const GltfFile& file);

  /// The picture of a textureInfo, such as a material's "baseColorTexture". The reference stays valid.
  ///
  /// throws  InputError
  GltfPicture& use(const JsonValue& texture_info);

 private:
  /// The index of a texture's image.
  std::size_t image_of(const JsonValue& texture) const;
  GltfPicture read(const JsonValue& image, const Sampling& sampling);
  GltfPicture decode(const JsonValue& image, std::string_view bytes, const Sampling& sampling);
  image::Levels decode_png_or_jpeg(const JsonValue& image, std::string_view bytes);
  image::Levels decode_webp(const JsonValue& image, std::string_view bytes);
  /// Counts a picture before its memory is allocated.
  void take(const JsonValue& image, int width, int height);
  Sampling sampling_of(const JsonValue& texture) const;

  const GltfFile& file_;
  std::vector<JsonValue> textures_;
  std::vector<JsonValue> images_;
  std::vector<JsonValue> samplers_;
  std::map<std::size_t, std::map<Sampling, GltfPicture>> pictures_;  // by image
  TexelBudget budget_;
};

}  // namespace litfog::scene
