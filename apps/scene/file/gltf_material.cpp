// SPDX-License-Identifier: Apache-2.0
#include "scene/file/gltf_material.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/file/gltf_value.h"

namespace litfog::scene {
namespace {

constexpr float kMaxShininess = 1000;

/// The colour of `size` numbers, of which RGB count, or what stands for it where none is given.
glm::vec3 color_or(const JsonValue& object, const char* name, std::size_t size, const glm::vec3& absent) {
  const auto value = object.optional(name);
  if (!value) return absent;
  const std::vector<double> color = numbers(*value, size);
  const bool is_color = std::ranges::all_of(color, [](double x) { return x >= 0 && x <= 1; });
  if (!is_color) value->fail(fmt::format("must be {} numbers in [0, 1]", size));
  return {color[0], color[1], color[2]};
}

float factor_of(const JsonValue& object, const char* name) {
  const double factor = object.number_or(name, 1);
  if (!(factor >= 0 && factor <= 1)) object.member(name).fail("must be in [0, 1]");
  return float(factor);
}

}  // namespace

GltfMaterials::GltfMaterials(const GltfFile& file)
    : empty_(files::parse_json("{}", file.root().file())),
      given_(items_of(file.root(), "materials")),
      used_(given_.size() + 1),
      pictures_(file),
      white_(Texels{1, 1, {255, 255, 255, 255}}),
      flat_(std::make_shared<const Texels>(Texels{1, 1, {128, 128, 255, 0}})) {}

const GltfMaterial& GltfMaterials::use(const JsonValue& primitive) {
  const auto index = primitive.optional("material");
  const std::size_t at = index ? index_in(given_, *index) : given_.size();
  std::optional<GltfMaterial>& used = used_[at];
  if (used) return *used;
  const JsonValue& given = index ? given_[at] : empty_;
  const auto double_sided = given.optional("doubleSided");
  used = GltfMaterial{.index = materials_.size(),
                      .name = index ? fmt::format("glTF material {}", at) : "glTF material -1",
                      .is_double_sided = double_sided && double_sided->boolean()};
  materials_.push_back(make(used->name, given));
  return *used;
}

Material GltfMaterials::make(const std::string& name, const JsonValue& given) {
  const JsonValue pbr = given.optional("pbrMetallicRoughness").value_or(empty_);
  const glm::vec3 factor = color_or(pbr, "baseColorFactor", 4, glm::vec3(1));
  const auto base_texture = pbr.optional("baseColorTexture");
  GltfPicture& base = base_texture ? pictures_.use(*base_texture) : white_;
  const auto rough_texture = pbr.optional("metallicRoughnessTexture");
  const glm::vec3 rough = rough_texture ? pictures_.use(*rough_texture).mean() : glm::vec3(1);
  const float metallic = factor_of(pbr, "metallicFactor") * rough.b;
  const float roughness = factor_of(pbr, "roughnessFactor") * rough.g;
  const glm::vec3 reflected = glm::mix(glm::vec3(0.04f), base.linear_mean() * factor, metallic);
  const float alpha = std::max(roughness * roughness, 1e-3f);
  const float shininess = std::clamp(2 / (alpha * alpha) - 2, 1.0f, kMaxShininess);
  const glm::vec3 kept = factor * (1 - metallic);
  glm::vec3 emissive = color_or(given, "emissiveFactor", 3, glm::vec3(0));
  const auto emissive_texture = given.optional("emissiveTexture");
  if (emissive_texture && emissive != glm::vec3(0)) emissive *= pictures_.use(*emissive_texture).linear_mean();
  return {.name = name,
          .size_m = 1,
          .albedo = tinted(given, base.texels(), kept),
          .normal = normal_map(given),
          .specular = reflected * ((shininess + 8) / 8),
          .shininess = shininess,
          .emissive = emissive,
          .plain_albedo = base_texture ? std::nullopt : std::optional(kept)};
}

GltfMaterials::SharedTexels GltfMaterials::tinted(const JsonValue& material, const SharedTexels& picture,
                                                  const glm::vec3& factor) {
  if (factor == glm::vec3(1)) return picture;
  SharedTexels& made = tinted_[{picture.get(), {factor.r, factor.g, factor.b}}];
  if (made) return made;
  made_.take(material, picture->rgba.size() / 4);
  Texels texels = *picture;
  for (std::size_t i = 0; i < texels.rgba.size(); i += 4) {
    for (int channel = 0; channel < 3; ++channel) {
      std::uint8_t& texel = texels.rgba[i + std::size_t(channel)];
      if (factor[channel] != 1) texel = srgb_level_of(linear_value(texel) * factor[channel]);
    }
  }
  return made = std::make_shared<const Texels>(std::move(texels));
}

GltfMaterials::SharedTexels GltfMaterials::normal_map(const JsonValue& material) {
  const auto info = material.optional("normalTexture");
  if (!info) return flat_;
  const SharedTexels picture = pictures_.use(*info).texels();
  const double given = info->number_or("scale", 1);
  if (given == 1) return picture;
  if (!(std::abs(given) <= 1000)) info->member("scale").fail("must be at most 1000");
  const auto scale = float(given);
  SharedTexels& made = scaled_normals_[{picture.get(), scale}];
  if (made) return made;
  made_.take(material, picture->rgba.size() / 4);
  Texels texels = *picture;
  for (std::size_t i = 0; i < texels.rgba.size(); i += 4) {
    glm::vec3 normal;
    for (int axis = 0; axis < 3; ++axis) normal[axis] = float(texels.rgba[i + std::size_t(axis)]) / 127.5f - 1;
    normal = glm::normalize(normal * glm::vec3(scale, scale, 1));
    for (int axis = 0; axis < 3; ++axis) texels.rgba[i + std::size_t(axis)] = level_of(normal[axis] * 0.5f + 0.5f);
  }
  return made = std::make_shared<const Texels>(std::move(texels));
}

}  // namespace litfog::scene
