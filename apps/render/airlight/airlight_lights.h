// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

#include "litfog/gl/program.h"
#include "render/airlight/airlight_list.h"
#include "render/airlight/airlight_tiles.h"
#include "render/gpu/data_texture.h"
#include "render/gpu/pass_textures.h"

namespace litfog::render {

/// Holds on the GPU the lights whose airlight frames draw within the lights' extents, and their list for each tile of
/// the picture. Needs a current GL context.
class AirlightLights {
 public:
  /// Uploads the lists. A list without entries uploads nothing.
  void set(const AirlightList& list, const AirlightTiles& tiles);

  /// The entries of each kind.
  std::span<const AirlightList::Range> ranges() const { return ranges_; }
  int size() const { return size_; }
  /// Those that are no peaks of higher orders; they come first.
  int single_count() const { return single_count_; }
  /// Entries of a range that a tile has at most.
  int longest_list(std::size_t range) const { return longest_lists_[range]; }
  /// Lets a pass read the entries (shaders/airlight/airlight_entry.glsl).
  void bind_entries(PassTextures& textures) const;
  /// Also lets a pass read the tiles of a range (shaders/airlight/airlight_lights.frag).
  void bind_tiles(const gl::Program& program, PassTextures& textures, std::size_t range) const;

 private:
  std::vector<AirlightList::Range> ranges_;
  std::vector<int> longest_lists_;  // one a range
  int size_ = 0;
  int single_count_ = 0;
  std::optional<BufferTexture> entries_;
  std::optional<BufferTexture> tile_lists_;  // AirlightTiles::lists
  glm::ivec2 tile_count_{0};
  glm::vec2 tile_size_{0};  // pixels
};

}  // namespace litfog::render
