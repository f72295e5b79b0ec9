// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include "litfog/gl/gl_name.h"
#include "litfog/gl/program.h"
#include "render/gpu/pass_textures.h"

namespace litfog::render {

/// Airlight at the texels of a grid, in floats: half floats would lose what faint lights add to bright ones.
struct AirlightTarget {
  glm::ivec2 size{0};
  gl::FramebufferName framebuffer;
  gl::TextureName airlight;  ///< alpha: opacity of the fog before the surface seen, or kNotFilled
  gl::TextureName gain;      ///< airlight per opacity of the fog; the finest grid has none
  gl::RenderbufferName stencil;

  /// The alpha of a texel that has no airlight yet (is_filled() in shaders/airlight/texel.glsl).
  static constexpr float kNotFilled = -1;
  /// The stencil of a marked texel; all others have 0.
  static constexpr int kMarked = 1;

  /// Creates textures and stencil of a size. Nobody reads the finest grid's gain, but drivers compile a program anew for
  /// another number of targets.
  ///
  /// throws  gl::Unsupported where the driver cannot draw into textures of floats of that size
  void set_size(glm::ivec2 new_size);
};

/// Blocks of texels that are drawn as points (shaders/airlight/block_point.glsl).
struct AirlightBlocks {
  glm::ivec2 count;
  glm::ivec2 stride;  ///< from one block to the next, in blocks
  glm::ivec2 target;  ///< size in texels
  bool is_packed;     ///< by PackedTexels: the texels stand for texels elsewhere in a grid

  /// All texels of a target, each standing for itself.
  static AirlightBlocks all_of(const AirlightTarget& target);

  /// Sets the uniforms of block_point.glsl, and the viewport.
  void set(const gl::Program& program) const;
};

/// Packs the texels of a grid that are not filled into a target of their own. Drawn where they lie, they would leave
/// most lanes of a processor idle. Needs a current GL context.
class PackedTexels {
 public:
  PackedTexels();

  /// Sets the size of the finest grid.
  ///
  /// throws  gl::Unsupported where the driver cannot draw into textures of floats of that size
  void set_size(glm::ivec2 finest);
  /// Packs the texels of a grid that are not filled, and marks those in use in target(). Needs a vertex array without
  /// attributes bound and the stencil test enabled.
  AirlightBlocks pack(const AirlightTarget& grid);
  const AirlightTarget& target() const { return packed_; }
  /// Lets a pass over packed blocks read where the texels lie in their grid (shaders/airlight/airlight_lights.frag).
  void bind_positions(PassTextures& textures) const;
  void bind_marks(PassTextures& textures) const { textures.bind("block_marks", marks_, GL_TEXTURE_RECTANGLE); }
  /// Lets the pass of airlight_unpack.frag read target().
  void bind_packed(const gl::Program& program, PassTextures& textures, const AirlightBlocks& blocks) const;

 private:
  gl::Program marks_program_;
  gl::Program pack_program_;
  AirlightTarget packed_;
  gl::FramebufferName marks_framebuffer_;
  gl::TextureName marks_;  // which texels are not filled
  gl::FramebufferName positions_framebuffer_;
  gl::TextureName positions_;
};

}  // namespace litfog::render
