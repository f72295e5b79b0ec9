// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "render/airlight/airlight_list.h"
#include "scene/camera.h"

namespace litfog::render {

/// The lights whose airlight each tile of a picture can show. Tiles are equal, of some 32 pixels a side or more.
struct AirlightTiles {
  glm::ivec2 count{0};  ///< columns and rows
  glm::ivec2 size{0};   ///< pixels that they cover, which is more than the picture's: grids reach beyond its edges
  /// For each range of the AirlightList and each tile, row by row from the bottom, where its entries begin in this and
  /// where they end; then the entries.
  std::vector<std::int32_t> lists;
};

/// No entry is missing from a tile through which a ray passes its light within its bounds. The entries of a tile are in
/// the order of the list. A view that is wider than litfog::View takes is one tile.
///
/// picture_size  pixels
/// beyond        pixels to the right of the picture and above it that tiles cover, too
AirlightTiles list_airlight_tiles(const AirlightList& list, const scene::Camera& camera, glm::ivec2 picture_size,
                                  int beyond);

}  // namespace litfog::render
