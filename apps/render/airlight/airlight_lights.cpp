// SPDX-License-Identifier: Apache-2.0
#include "render/airlight/airlight_lights.h"

#include <algorithm>

namespace litfog::render {

void AirlightLights::set(const AirlightList& list, const AirlightTiles& tiles) {
  ranges_ = list.ranges;
  size_ = int(list.entries.size());
  single_count_ = 0;
  for (const AirlightList::Range& range : ranges_) single_count_ += range.kind.has_higher_orders ? 0 : int(range.count);
  if (size_ == 0) return;
  entries_.emplace(list.entries.data(), std::span(list.entries).size_bytes(), BufferTexture::Texel::float4);
  tile_lists_.emplace(tiles.lists.data(), std::span(tiles.lists).size_bytes(), BufferTexture::Texel::int1);
  tile_count_ = tiles.count;
  longest_lists_.assign(ranges_.size(), 0);
  const std::size_t count = std::size_t(tiles.count.x) * std::size_t(tiles.count.y);
  for (std::size_t i = 0; i < ranges_.size() * count; ++i) {
    longest_lists_[i / count] = std::max(longest_lists_[i / count], tiles.lists[2 * i + 1] - tiles.lists[2 * i]);
  }
  tile_size_ = glm::vec2(tiles.size) / glm::vec2(tiles.count);
}

void AirlightLights::bind_entries(PassTextures& textures) const {
  const unsigned unit = textures.unit("airlight_entries");
  if (entries_) entries_->bind(unit);
}

void AirlightLights::bind_tiles(const gl::Program& program, PassTextures& textures, std::size_t range) const {
  tile_lists_->bind(textures.unit("tile_lists"));
  set_uniform(program, "tile_count", tile_count_);
  set_uniform(program, "tile_size", tile_size_);
  set_uniform(program, "first_tile", int(range) * 2 * tile_count_.x * tile_count_.y);
}

}  // namespace litfog::render
