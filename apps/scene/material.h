// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>

#include "scene/texels.h"

namespace litfog::scene {

/// What a surface is made of.
struct Material {
  std::string name;
  float size_m;  ///< metres that one tile covers: texture coordinate = Vertex::uv / size_m
  /// sRGB colour; A = gloss, linear, scales specular; or coverage of a mask, whose gloss is 1. Materials share equal
  /// pictures.
  std::shared_ptr<const Texels> albedo;
  /// Tangent space, +Z out of the surface; A < 255: n = (rgb - 128) / 127.5, in which flat is exact, and A is the
  /// height, 254 the highest; A = 255: n = rgb / 127.5 - 1, as in glTF, which states no heights.
  std::shared_ptr<const Texels> normal;
  float normal_scale = 1;  ///< multiplies the normal's x and y before normalisation
  glm::vec3 specular;      ///< linear, at gloss 1
  float shininess;         ///< Blinn-Phong exponent
  glm::vec3 emissive;      ///< linear; 0 if it emits nothing
  float relief_m = 0;      ///< from height 0 to 254, metres, for parallax mapping
  /// Root mean square slope of a metal's facets (Cook and Torrance's m), for paths with their own metal models; 0: no
  /// metal.
  float metal_roughness = 0;
  /// Linear, gloss 1: replaces an albedo of one colour, because 8 bits are some percent off for dark colours.
  std::optional<glm::vec3> plain_albedo = std::nullopt;
  /// Ka of the Basic model: linear reflectance of ambient light; none: the albedo.
  std::optional<glm::vec3> ambient = std::nullopt;
  /// sRGB colour that multiplies emissive; null: 1.
  std::shared_ptr<const Texels> emission = nullptr;
  /// sRGB colour that multiplies the reflectance, in tiles of its own (Hales 2004, "face texture 2 (if any)"); null: 1.
  std::shared_ptr<const Texels> second = nullptr;
  float second_size_m = 1;  ///< as size_m
  /// A mask: no surface where its coverage, times the vertices', is less than this. > 0.
  std::optional<float> least_coverage = std::nullopt;
  /// A pane: this times its coverage, times the vertices', is the fraction of the background that it hides. [0, 1]. Its
  /// least_coverage is the least that casts a shadow, and its mask for paths that draw surfaces in several passes.
  std::optional<float> opacity = std::nullopt;
  /// Emits emissive times the base colour, and reflects nothing.
  bool is_unlit = false;
};

}  // namespace litfog::scene
