// SPDX-License-Identifier: Apache-2.0
#include "scene/file/gltf_material.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/gtc/type_ptr.hpp>

#include "model/float_limit.h"
#include "scene/file/gltf_value.h"
#include "scene/scene.h"

namespace litfog::scene {
namespace {

constexpr float kMaxShininess = 1000;
constexpr double kBlendCutoff = 0.5;  // least alpha at which blended materials cast shadows

/// Exporters that convert between colour spaces write 1.00016. No display shows an excess of a quarter of an 8-bit step
/// in sRGB.
constexpr double kMaxReflectance = 1 + 1.0 / 510;

/// A colour of `size` numbers.
std::vector<double> color_of(const JsonValue& value, std::size_t size) {
  std::vector<double> color = numbers(value, size);
  for (double& x : color) {
    if (!(x >= 0 && x <= kMaxReflectance)) value.fail(fmt::format("must be {} numbers in [0, 1]", size));
    x = std::min(x, 1.0);
  }
  return color;
}

/// The base colour's factor with its alpha; the texels lack that alpha.
glm::dvec4 base_factor_of(const JsonValue& pbr) {
  const auto factor = pbr.optional("baseColorFactor");
  return factor ? glm::make_vec4(color_of(*factor, 4).data()) : glm::dvec4(1);
}

glm::vec3 emissive_of(const JsonValue& material) {
  const auto factor = material.optional("emissiveFactor");
  glm::vec3 emissive = factor ? glm::vec3(glm::make_vec3(color_of(*factor, 3).data())) : glm::vec3(0);
  if (const auto extension = extension_of(material, "KHR_materials_emissive_strength")) {
    const double strength = snapped(extension->number_or("emissiveStrength", 1), 0, kMaxColor);
    if (!(strength >= 0 && strength <= kMaxColor)) {
      extension->member("emissiveStrength").fail(fmt::format("must be in [0, {}]", kMaxColor));
    }
    emissive *= float(strength);
  }
  return emissive;
}

std::optional<GltfCoordinates> coordinates_of(const JsonValue& object, const char* texture) {
  const auto info = object.optional(texture);
  return info ? std::optional(scene::coordinates_of(*info)) : std::nullopt;
}

float normal_scale_of(const JsonValue& texture_info) {
  const double scale = texture_info.number_or("scale", 1);
  if (!is_within(scale, -1000, 1000)) texture_info.member("scale").fail("must be at most 1000");
  return float(scale);
}

float factor_of(const JsonValue& object, const char* name) {
  const double factor = snapped(object.number_or(name, 1), 0, 1);
  if (!(factor >= 0 && factor <= 1)) object.member(name).fail("must be in [0, 1]");
  return float(factor);
}

bool is_blended(const JsonValue& material) {
  const auto mode = material.optional("alphaMode");
  return mode && mode->string() == "BLEND";
}

/// Material::least_coverage.
std::optional<float> least_coverage_of(const JsonValue& material, const JsonValue& pbr) {
  const auto mode = material.optional("alphaMode");
  if (!mode || mode->string() == "OPAQUE") return std::nullopt;
  if (!is_blended(material) && mode->string() != "MASK") mode->fail("must be OPAQUE, MASK or BLEND");
  const double cutoff = is_blended(material) ? kBlendCutoff : material.number_or("alphaCutoff", 0.5);
  if (!(cutoff >= 0)) material.member("alphaCutoff").fail("must be >= 0");
  if (cutoff == 0) return std::nullopt;
  return float(cutoff / base_factor_of(pbr).a);  // alpha 0 leaves no surface
}

/// Material::opacity.
std::optional<float> opacity_of(const JsonValue& material, const JsonValue& pbr) {
  return is_blended(material) ? std::optional(float(base_factor_of(pbr).a)) : std::nullopt;
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
  const JsonValue pbr = given.optional("pbrMetallicRoughness").value_or(empty_);
  const auto double_sided = given.optional("doubleSided");
  const auto base = coordinates_of(pbr, "baseColorTexture");
  const auto rough = coordinates_of(pbr, "metallicRoughnessTexture");
  const auto normal = coordinates_of(given, "normalTexture");
  const auto emission = coordinates_of(given, "emissiveTexture");
  const GltfCoordinates first = base.value_or(rough.value_or(normal.value_or(emission.value_or(GltfCoordinates{}))));
  used = GltfMaterial{.name = index ? fmt::format("glTF material {}", at) : "glTF material -1",
                      .is_double_sided = double_sided && double_sided->boolean(),
                      .sets = {},
                      .base = first,
                      .normal = normal.value_or(first),
                      .emission = emission.value_or(first)};
  for (const auto& texture : {base, rough, normal, emission}) {
    if (texture) used->sets.insert(texture->set);
  }
  if (const auto extensions = given.optional("extensions")) {
    for (const std::string_view name : extensions->names()) extensions_.emplace(name);
  }
  const bool is_unlit = extension_of(given, "KHR_materials_unlit").has_value();
  materials_.push_back(is_unlit ? make_unlit(used->name, given, pbr) : make_lit(used->name, given, pbr));
  return *used;
}

GltfMaterials::SharedTexels GltfMaterials::base_texels(const JsonValue& material,
                                                       const std::optional<JsonValue>& texture, bool is_masked) {
  if (!texture) return white_.texels();
  GltfPicture& picture = pictures_.use(*texture);
  return is_masked ? picture.covering_texels(material, made_) : picture.texels();
}

Material GltfMaterials::make_unlit(const std::string& name, const JsonValue& given, const JsonValue& pbr) {
  const std::optional<float> least_coverage = least_coverage_of(given, pbr);
  const auto texture = pbr.optional("baseColorTexture");
  return {.name = name,
          .size_m = 1,
          .albedo = base_texels(given, texture, least_coverage.has_value()),
          .normal = flat_,
          .specular = glm::vec3(0),
          .shininess = 1,
          .emissive = glm::vec3(base_factor_of(pbr)),
          .plain_albedo = texture ? std::nullopt : std::optional(glm::vec3(1)),
          .least_coverage = least_coverage,
          .opacity = opacity_of(given, pbr),
          .is_unlit = true};
}

Material GltfMaterials::make_lit(const std::string& name, const JsonValue& given, const JsonValue& pbr) {
  const glm::vec3 factor(base_factor_of(pbr));
  const auto base_texture = pbr.optional("baseColorTexture");
  GltfPicture& base = base_texture ? pictures_.use(*base_texture) : white_;
  const auto rough_texture = pbr.optional("metallicRoughnessTexture");
  const glm::vec3 rough = rough_texture ? pictures_.use(*rough_texture).mean() : glm::vec3(1);
  const float metallic = factor_of(pbr, "metallicFactor") * rough.b;
  const float roughness = factor_of(pbr, "roughnessFactor") * rough.g;
  const glm::vec3 reflected = glm::mix(glm::vec3(0.04f), base.linear_mean() * factor, metallic);
  const float alpha = std::max(roughness * roughness, 1e-3f);
  const float shininess = std::clamp(2 / (alpha * alpha) - 2, 1.0f, kMaxShininess);
  // Metal has no diffuse colour. If the metal texture has its own coordinates, its mean counts.
  Metal metal{.factor = factor_of(pbr, "metallicFactor")};
  const bool is_by_texel = rough_texture && metal.factor > 0 &&
                           scene::coordinates_of(*rough_texture) ==
                               coordinates_of(pbr, "baseColorTexture").value_or(scene::coordinates_of(*rough_texture));
  if (is_by_texel) metal.texels = pictures_.use(*rough_texture).texels();
  const glm::vec3 kept = is_by_texel ? factor : factor * (1 - metallic);
  const std::optional<float> least_coverage = least_coverage_of(given, pbr);
  const glm::vec3 emissive = emissive_of(given);
  const auto normal_texture = given.optional("normalTexture");
  const auto emissive_texture = given.optional("emissiveTexture");
  const bool has_emission = emissive_texture && emissive != glm::vec3(0);
  if (given.optional("occlusionTexture")) ++occluded_;
  return {.name = name,
          .size_m = 1,
          .albedo = tinted(given, base_texels(given, base_texture, least_coverage.has_value()), kept, metal),
          .normal = normal_texture ? pictures_.use(*normal_texture).texels() : flat_,
          .normal_scale = normal_texture ? normal_scale_of(*normal_texture) : 1,
          .specular = reflected * ((shininess + 8) / 8),
          .shininess = shininess,
          .emissive = emissive,
          .plain_albedo = base_texture || is_by_texel ? std::nullopt : std::optional(kept),
          .emission = has_emission ? pictures_.use(*emissive_texture).texels() : nullptr,
          .least_coverage = least_coverage,
          .opacity = opacity_of(given, pbr)};
}

GltfMaterials::SharedTexels GltfMaterials::tinted(const JsonValue& material, const SharedTexels& picture,
                                                  const glm::vec3& factor, const Metal& metal) {
  if (factor == glm::vec3(1) && !metal.texels) return picture;
  SharedTexels& made = tinted_[{picture.get(), metal.texels.get(), {factor.r, factor.g, factor.b, metal.factor}}];
  if (made) return made;
  const Texels& size = metal.texels && picture->rgba.size() == 4 ? *metal.texels : *picture;
  const auto width = std::size_t(size.width);
  const auto height = std::size_t(size.height);
  made_.take(material, width * height);
  Texels texels{size.width, size.height, std::vector<std::uint8_t>(4 * width * height), size.sampling};
  const auto texel_of = [&](const Texels& of, std::size_t x, std::size_t y) {  // nearest, if sizes differ
    return &of.rgba[4 *
                    (y * std::size_t(of.height) / height * std::size_t(of.width) + x * std::size_t(of.width) / width)];
  };
  for (std::size_t y = 0; y < height; ++y) {
    for (std::size_t x = 0; x < width; ++x) {
      const std::uint8_t* const from = texel_of(*picture, x, y);
      const float kept = metal.texels ? 1 - metal.factor * float(texel_of(*metal.texels, x, y)[2]) / 255 : 1;
      std::uint8_t* const to = &texels.rgba[4 * (y * width + x)];
      for (int channel = 0; channel < 3; ++channel) {
        const float scale = factor[channel] * kept;
        to[channel] = scale == 1 ? from[channel] : srgb_level_of(linear_value(from[channel]) * scale);
      }
      to[3] = from[3];
    }
  }
  return made = std::make_shared<const Texels>(std::move(texels));
}

}  // namespace litfog::scene
