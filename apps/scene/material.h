// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace litfog::scene {

/// A tiling picture, RGBA8. Row 0 is v = 0 and texel 0 of a row is u = 0 (OpenGL's upload order).
struct Texels {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;
};

/// A texel's level for a share, clamped to [0, 1]; and for a linear value, clamped likewise, as sRGB.
std::uint8_t level_of(float share);
std::uint8_t srgb_level_of(float linear);

/// What a surface is made of.
struct Material {
  std::string name;
  float size_m;        ///< metres one tile covers: texture coordinate = Vertex::uv / size_m
  Texels albedo;       ///< sRGB colour; A = gloss, linear, scales specular
  Texels normal;       ///< tangent space, +Z out of the surface; n = (rgb - 128) / 127.5 where A = 0, which can say
                       ///< flat, and rgb / 127.5 - 1, glTF's, where A = 255
  glm::vec3 specular;  ///< linear, at gloss 1
  float shininess;     ///< Blinn-Phong exponent
  glm::vec3 emissive;  ///< linear; 0 for what does not shine
  /// Linear, gloss 1: in place of an albedo of one colour, which in 8 bits is up to some percent off where it is dark.
  std::optional<glm::vec3> plain_albedo = std::nullopt;
};

/// Every material there is, sorted.
std::span<const std::string_view> material_names();

/// Paints a material, both pictures square and a power of two a side; the same name gives the same bytes.
/// throws std::invalid_argument for an unknown name
Material make_material(std::string_view name);

}  // namespace litfog::scene
