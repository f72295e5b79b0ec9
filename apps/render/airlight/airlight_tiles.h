// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "render/airlight/airlight_list.h"
#include "scene/camera.h"

namespace litfog::render {

/// The lights whose airlight each tile of a picture can show. Tiles have equal sizes, some 32 pixels a side or more.
struct AirlightTiles {
  glm::ivec2 count{0};  ///< columns and rows
  glm::ivec2 size{0};   ///< pixels that all tiles cover: more than the picture, beyond whose edges grids reach
  /// For each range of the AirlightList and each tile, row by row from the bottom: the indices in this vector where the
  /// tile's entries begin and end. Then all entries.
  std::vector<std::int32_t> lists;
};

/// Lists an entry at least in each tile that has a ray through the entry's bounds, in the order of `list`. A view wider
/// than litfog::View allows is one tile.
///
/// picture_size  pixels
/// beyond        pixels right of the picture and above it that tiles also cover
AirlightTiles list_airlight_tiles(const AirlightList& list, const scene::Camera& camera, glm::ivec2 picture_size,
                                  int beyond);

}  // namespace litfog::render
