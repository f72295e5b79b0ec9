// SPDX-License-Identifier: Apache-2.0
#include "render/airlight/packed_texels.h"

#include <epoxy/gl.h>

#include "render/gpu/framebuffer.h"
#include "render/gpu/render_shaders.h"
#include "render/gpu/texel_target.h"

namespace litfog::render {
namespace {

constexpr int kBlock = 16;  // texels a side: block_size in airlight_blocks.glsl

glm::ivec2 blocks_over(glm::ivec2 size) { return (size + (kBlock - 1)) / kBlock; }

void attach_stencil(const AirlightTarget& target) {
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_STENCIL_ATTACHMENT, GL_RENDERBUFFER, target.stencil.id());
}

}  // namespace

void AirlightTarget::set_size(glm::ivec2 new_size) {
  size = new_size;
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
  attach_texels(GL_COLOR_ATTACHMENT0, airlight, size, GL_RGBA32F);
  attach_texels(GL_COLOR_ATTACHMENT1, gain, size, GL_RGBA32F);
  const GLenum targets[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
  glDrawBuffers(2, targets);
  glBindRenderbuffer(GL_RENDERBUFFER, stencil.id());
  glRenderbufferStorage(GL_RENDERBUFFER, GL_STENCIL_INDEX8, size.x, size.y);
  attach_stencil(*this);
  check_float_framebuffer();
}

AirlightBlocks AirlightBlocks::all_of(const AirlightTarget& target) {
  const glm::ivec2 count = blocks_over(target.size);
  return {count, glm::ivec2(1), count * kBlock, false};
}

void AirlightBlocks::set(const gl::Program& program) const {
  glViewport(0, 0, target.x, target.y);
  set_uniform(program, "is_packed", is_packed);
  set_uniform(program, "block_columns", count.x);
  set_uniform(program, "block_stride", stride);
  set_uniform(program, "target_size", glm::vec2(target));
  glEnable(GL_PROGRAM_POINT_SIZE);
}

PackedTexels::PackedTexels()
    : marks_program_("whole_picture.vert", "airlight/airlight_marks.frag", render_shaders()),
      pack_program_("airlight/airlight_blocks.vert", "airlight/airlight_pack.frag", render_shaders()) {}

void PackedTexels::set_size(glm::ivec2 finest) {
  const glm::ivec2 most_blocks = blocks_over(finest);
  packed_.set_size(most_blocks * kBlock);
  glBindFramebuffer(GL_FRAMEBUFFER, marks_framebuffer_.id());
  attach_texels(GL_COLOR_ATTACHMENT0, marks_, most_blocks * glm::ivec2(2, 1), GL_RGBA32UI);
  check_float_framebuffer();
  glBindFramebuffer(GL_FRAMEBUFFER, positions_framebuffer_.id());
  attach_texels(GL_COLOR_ATTACHMENT0, positions_, packed_.size, GL_RG32F);
  attach_stencil(packed_);
  check_float_framebuffer();
}

// Blocks are spread over the target where it has room: drivers split a framebuffer into large tiles, one per core, and
// a coarse grid alone would fill only one.
AirlightBlocks PackedTexels::pack(const AirlightTarget& grid) {
  const glm::ivec2 count = blocks_over(grid.size), room = packed_.size / kBlock;
  const AirlightBlocks blocks{count, glm::max((room - 1) / glm::max(count - 1, 1), 1), packed_.size, true};
  glBindFramebuffer(GL_FRAMEBUFFER, marks_framebuffer_.id());
  glViewport(0, 0, 2 * count.x, count.y);
  marks_program_.use();
  PassTextures(marks_program_).bind("airlight", grid.airlight, GL_TEXTURE_RECTANGLE);
  glDrawArrays(GL_TRIANGLES, 0, 3);

  glBindFramebuffer(GL_FRAMEBUFFER, positions_framebuffer_.id());
  glClear(GL_STENCIL_BUFFER_BIT);
  glStencilFunc(GL_ALWAYS, AirlightTarget::kMarked, 0xff);
  glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
  pack_program_.use();
  PassTextures textures(pack_program_);
  bind_marks(textures);
  blocks.set(pack_program_);
  glDrawArrays(GL_POINTS, 0, count.x * count.y);
  glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  return blocks;
}

void PackedTexels::bind_positions(PassTextures& textures) const {
  bind_marks(textures);
  textures.bind("packed_positions", positions_, GL_TEXTURE_RECTANGLE);
}

void PackedTexels::bind_packed(const gl::Program& program, PassTextures& textures, const AirlightBlocks& blocks) const {
  bind_marks(textures);
  textures.bind("packed_airlight", packed_.airlight, GL_TEXTURE_RECTANGLE);
  textures.bind("packed_gain", packed_.gain, GL_TEXTURE_RECTANGLE);
  set_uniform(program, "block_stride", blocks.stride);
}

}  // namespace litfog::render
