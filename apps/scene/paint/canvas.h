// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "scene/paint/field.h"

namespace litfog::scene {

/// What a painter fills in per texel: height (metres; the normals are computed from it), linear colour and gloss.
struct Canvas {
  Canvas(int texels, float metres)
      : size(texels), size_m(metres), height(texels), gloss(texels, 1.0f), color(height.texels(), glm::vec3(1.0f)) {}
  int size;
  float size_m;
  Field height;
  Field gloss;  ///< [0, 1]
  std::vector<glm::vec3> color;

  float texel_m() const { return size_m / float(size); }
};

}  // namespace litfog::scene
