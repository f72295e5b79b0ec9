// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>

#include "scene/texels.h"

namespace litfog::scene {

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

}  // namespace litfog::scene
