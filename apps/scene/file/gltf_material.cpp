// SPDX-License-Identifier: Apache-2.0
#include "scene/file/gltf_material.h"

#include <OpenImageIO/color.h>
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace litfog::scene {
namespace {

constexpr std::size_t kMaxTexels = std::size_t{1} << 27;  // of all pictures together: 512 MiB
constexpr int kMaxPictureSide = 16'384;
constexpr float kMaxShininess = 1000;

float linear(std::uint8_t srgb) { return OIIO::sRGB_to_linear(float(srgb) / 255.0f); }

/// The mean of a picture's texels, as colours or as they are.
glm::vec3 mean(const Texels& texels, bool is_srgb) {
  glm::dvec3 sum(0.0);
  for (std::size_t i = 0; i < texels.rgba.size(); i += 4) {
    for (int channel = 0; channel < 3; ++channel) {
      const std::uint8_t value = texels.rgba[i + std::size_t(channel)];
      sum[channel] += double(is_srgb ? linear(value) : float(value) / 255.0f);
    }
  }
  return sum / double(texels.rgba.size() / 4);
}

}  // namespace

std::string GltfMaterials::use(const GltfPlace& place, int number) {
  const std::vector<tinygltf::Material>& given = file_.model().materials;
  const std::size_t at = number == -1 ? given.size() : file_.index(place, number, given.size());
  const std::string name = fmt::format("glTF material {}", number);
  if (is_used_[at]) return name;
  is_used_[at] = true;
  materials_.push_back(number == -1 ? make(name, GltfPlace{}, tinygltf::Material{})
                                    : make(name, GltfPlace{} / "materials" / at, given[at]));
  return name;
}

Material GltfMaterials::make(const std::string& name, const GltfPlace& place, const tinygltf::Material& given) {
  const tinygltf::PbrMetallicRoughness& pbr = given.pbrMetallicRoughness;
  const GltfPlace pbr_place = place / "pbrMetallicRoughness";
  const glm::vec3 factor = color_of(pbr_place / "baseColorFactor", pbr.baseColorFactor, 4);
  Texels base = texture(pbr_place / "baseColorTexture", pbr.baseColorTexture, {255, 255, 255});
  const Texels rough = texture(pbr_place / "metallicRoughnessTexture", pbr.metallicRoughnessTexture, {255, 255, 255});
  const glm::vec3 rough_mean = mean(rough, false);
  const float metallic = share_of(pbr_place / "metallicFactor", pbr.metallicFactor) * rough_mean.b;
  const float roughness = share_of(pbr_place / "roughnessFactor", pbr.roughnessFactor) * rough_mean.g;
  const glm::vec3 reflected = glm::mix(glm::vec3(0.04f), mean(base, true) * factor, metallic);
  const float alpha = std::max(roughness * roughness, 1e-3f);
  const float shininess = std::clamp(2 / (alpha * alpha) - 2, 1.0f, kMaxShininess);
  const glm::vec3 kept = factor * (1 - metallic);
  for (std::size_t i = 0; i < base.rgba.size(); i += 4) {
    for (int channel = 0; channel < 3; ++channel) {
      std::uint8_t& texel = base.rgba[i + std::size_t(channel)];
      if (kept[channel] != 1) texel = srgb_level_of(linear(texel) * kept[channel]);
    }
    base.rgba[i + 3] = 255;  // gloss
  }
  glm::vec3 emissive(0.0f);
  if (!given.emissiveFactor.empty()) emissive = color_of(place / "emissiveFactor", given.emissiveFactor, 3);
  if (emissive != glm::vec3(0.0f)) {
    emissive *= mean(texture(place / "emissiveTexture", given.emissiveTexture, {255, 255, 255}), true);
  }
  return {.name = name,
          .size_m = 1,
          .albedo = std::move(base),
          .normal = normal_map(place / "normalTexture", given.normalTexture),
          .specular = reflected * ((shininess + 8) / 8),
          .shininess = shininess,
          .emissive = emissive,
          .plain_albedo = pbr.baseColorTexture.index == -1 ? std::optional(kept) : std::nullopt};
}

glm::vec3 GltfMaterials::color_of(const GltfPlace& place, const std::vector<double>& given, std::size_t size) const {
  const bool is_color = given.size() == size && std::ranges::all_of(given, [](double x) { return x >= 0 && x <= 1; });
  if (!is_color) file_.refuse(place, fmt::format("must be {} numbers in [0, 1]", size));
  return {given[0], given[1], given[2]};
}

float GltfMaterials::share_of(const GltfPlace& place, double given) const {
  if (!(given >= 0 && given <= 1)) file_.refuse(place, "must be in [0, 1]");
  return float(given);
}

Texels GltfMaterials::normal_map(const GltfPlace& place, const tinygltf::NormalTextureInfo& given) {
  if (given.index == -1) return {1, 1, {128, 128, 255, 0}};  // flat
  tinygltf::TextureInfo info;
  info.index = given.index;
  info.texCoord = given.texCoord;
  Texels texels = texture(place, info, {});
  if (given.scale == 1) return texels;
  if (!(std::abs(given.scale) <= 1000)) file_.refuse(place / "scale", "must be at most 1000");
  for (std::size_t i = 0; i < texels.rgba.size(); i += 4) {
    glm::vec3 normal;
    for (int axis = 0; axis < 3; ++axis) normal[axis] = float(texels.rgba[i + std::size_t(axis)]) / 127.5f - 1;
    normal = glm::normalize(normal * glm::vec3(float(given.scale), float(given.scale), 1));
    for (int axis = 0; axis < 3; ++axis) texels.rgba[i + std::size_t(axis)] = level_of(normal[axis] * 0.5f + 0.5f);
  }
  return texels;
}

Texels GltfMaterials::texture(const GltfPlace& place, const tinygltf::TextureInfo& info,
                              const std::array<std::uint8_t, 3>& absent) {
  if (info.index == -1) return {1, 1, {absent[0], absent[1], absent[2], 255}};
  if (info.texCoord != 0) file_.refuse(place / "texCoord", "must be 0: this program reads TEXCOORD_0 only");
  const tinygltf::Model& model = file_.model();
  const std::size_t at = file_.index(place / "index", info.index, model.textures.size());
  const GltfPlace source = GltfPlace{} / "textures" / at / "source";
  const std::size_t number = file_.index(source, model.textures[at].source, model.images.size());
  const tinygltf::Image& image = model.images[number];
  const GltfPlace own = GltfPlace{} / "images" / number;
  std::span<const unsigned char> bytes = image.image;
  if (image.bufferView >= 0) bytes = file_.view(own / "bufferView", image.bufferView);
  if (bytes.empty()) file_.refuse(own, "must be a picture that can be read");
  return decode(own, bytes);
}

Texels GltfMaterials::decode(const GltfPlace& place, std::span<const unsigned char> bytes) {
  constexpr std::array<unsigned char, 4> kPng{0x89, 'P', 'N', 'G'};
  constexpr std::array<unsigned char, 2> kJpeg{0xFF, 0xD8};
  const auto begins = [&](const auto& magic) {
    return bytes.size() >= magic.size() && std::equal(magic.begin(), magic.end(), bytes.begin());
  };
  if (!begins(kPng) && !begins(kJpeg)) file_.refuse(place, "must be a PNG or JPEG picture");
  OIIO::Filesystem::IOMemReader reader(const_cast<unsigned char*>(bytes.data()), bytes.size());
  const std::string format = begins(kPng) ? "png" : "jpeg";
  const auto input = OIIO::ImageInput::create(format);
  OIIO::ImageSpec config;
  config.attribute("oiio:UnassociatedAlpha", 1);  // else colours come multiplied by alpha
  OIIO::ImageSpec spec;
  if (!input) file_.refuse(place, "must be a picture of a kind that this OpenImageIO reads: " + OIIO::geterror());
  if (!input->set_ioproxy(&reader) || !input->open("picture." + format, spec, config)) {
    file_.refuse(place, "must be a sound picture: " + input->geterror());
  }
  if (spec.width > kMaxPictureSide || spec.height > kMaxPictureSide) {
    file_.refuse(place, fmt::format("must be at most {} pixels a side", kMaxPictureSide));
  }
  texels_ += spec.image_pixels();
  if (texels_ > kMaxTexels) file_.refuse(place, fmt::format("pictures must be at most {} pixels in all", kMaxTexels));
  const auto channels = std::size_t(spec.nchannels);
  std::vector<std::uint8_t> pixels(spec.image_pixels() * channels);
  if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::UINT8, pixels.data())) {
    file_.refuse(place, "must be a sound picture: " + input->geterror());
  }
  Texels texels{spec.width, spec.height, std::vector<std::uint8_t>(spec.image_pixels() * 4, 255)};
  for (std::size_t i = 0; i < spec.image_pixels(); ++i) {
    for (std::size_t channel = 0; channel < 3; ++channel) {  // a grey picture has one for all three
      texels.rgba[4 * i + channel] = pixels[i * channels + (channels < 3 ? 0 : channel)];
    }
  }
  return texels;
}

}  // namespace litfog::scene
