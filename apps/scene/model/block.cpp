// SPDX-License-Identifier: Apache-2.0
#include "scene/model/house.h"

#include <algorithm>

#include "scene/model/primitive.h"

namespace litfog::scene {

Model make_block(const Block& block) {
  const glm::vec3 size(block.width_m, block.height_m, block.depth_m);
  const float bevel = std::min(block.bevel_m, 0.45f * std::min(size.x, std::min(size.y, size.z)));
  return {{"concrete", bevel > 0.0f ? make_bevelled_box(size, bevel) : make_box(size)}};
}

}  // namespace litfog::scene
