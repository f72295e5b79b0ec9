// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace litfog::demo {

/// A tiling surface. Row 0 of the pictures is v = 0 and texel 0 of a row is u = 0 (OpenGL's upload order).
struct Material {
  std::string name;
  int size;                          ///< texels a side, a power of two
  float size_m;                      ///< metres one tile covers: texture coordinate = Vertex::uv / size_m
  std::vector<std::uint8_t> albedo;  ///< RGBA8: sRGB colour; A = gloss, linear, scales specular
  std::vector<std::uint8_t> normal;  ///< RGBA8: tangent space, n = rgb / 127.5 - 1, +Z out of the surface; A = 255
  glm::vec3 specular;                ///< linear, at gloss 1
  float shininess;                   ///< Blinn-Phong exponent
  glm::vec3 emissive;                ///< linear; 0 for what does not shine
};

/// Every material there is, sorted.
std::span<const std::string_view> material_names();

/// Paints a material; the same name gives the same bytes.
/// throws std::invalid_argument for an unknown name
Material make_material(std::string_view name);

}  // namespace litfog::demo
