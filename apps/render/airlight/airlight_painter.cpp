// SPDX-License-Identifier: Apache-2.0
#include "render/airlight/airlight_painter.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "render/airlight/airlight_tiles.h"
#include "render/gpu/depth.h"
#include "render/gpu/framebuffer.h"
#include "render/gpu/light_uniforms.h"
#include "render/gpu/render_shaders.h"
#include "render/gpu/texture_unit.h"
#include "render/gpu/uniform.h"
#include "render/plan/fog_top.h"

namespace litfog::render {
namespace {

constexpr int kStripes = 16;                            // of a target, between which an interruption may come
constexpr int kGridSteps[] = {kCoarsestGrid, 4, 2, 1};  // pixels
constexpr double kMostApart = 0.06;  // radians between a grid's texels: airlight is not known to be smoother
constexpr int kBlock = 16;           // of airlight_blocks.glsl: texels
constexpr GLint kMarked = 1;         // of a stencil, which is 0 elsewhere
constexpr GLenum kTargets[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};

/// Blocks that cover a size.
glm::ivec2 blocks(glm::ivec2 size) { return (size + (kBlock - 1)) / kBlock; }

/// Binds one of the textures that attach() makes, which are rectangles (shaders/airlight/texel.glsl).
void bind_texels(unsigned unit, const gl::TextureName& texture) { bind_texture(unit, texture, GL_TEXTURE_RECTANGLE); }

/// Makes a texture the bound framebuffer's.
void attach(GLenum attachment, const gl::TextureName& texture, glm::ivec2 size, GLint format = GL_RGBA32F) {
  bind_texels(kAirlightUnit, texture);
  const bool is_integer = format == GL_RGBA32UI;
  glTexImage2D(GL_TEXTURE_RECTANGLE, 0, format, size.x, size.y, 0, is_integer ? GL_RGBA_INTEGER : GL_RGBA,
               is_integer ? GL_UNSIGNED_INT : GL_FLOAT, nullptr);
  glTexParameteri(GL_TEXTURE_RECTANGLE, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_RECTANGLE, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glFramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_RECTANGLE, texture.id(), 0);
}

/// The program that reads the depths of a pixel's samples.
gl::Program make_seen_program(int samples) {
  const std::string count = fmt::format("#define SAMPLE_COUNT {}\n", samples);
  std::vector<gl::ShaderSource> files(render_shaders().begin(), render_shaders().end());
  files.push_back({"sample_count.glsl", count});
  return gl::Program("sky.vert", "airlight_seen.frag", files);
}

}  // namespace

AirlightPainter::AirlightPainter(const scene::Scene& scene, const gl::FogLightBuffer& fog_lights,
                                 const Framebuffer& framebuffer, const RenderSettings& settings)
    : scene_(scene),
      fog_lights_(fog_lights),
      far_(scene, fog_lights),
      shaft_steps_(settings.shaft_steps),
      tile_programs_(scene, "airlight_blocks.vert", "airlight_tiles.frag"),
      left_out_programs_(scene, "airlight_left_out.vert", "airlight_left_out.frag"),
      seen_program_(make_seen_program(framebuffer.samples())),
      fill_program_("whole_picture.vert", "airlight_fill.frag", render_shaders()),
      marks_program_("whole_picture.vert", "airlight_marks.frag", render_shaders()),
      pack_program_("airlight_blocks.vert", "airlight_pack.frag", render_shaders()),
      unpack_program_("whole_picture.vert", "airlight_unpack.frag", render_shaders()),
      add_program_("whole_picture.vert", "airlight_add.frag", render_shaders()) {
  set_size(framebuffer);
}

void AirlightPainter::set_size(const Framebuffer& framebuffer) {
  picture_size_ = {framebuffer.width(), framebuffer.height()};
  grids_.clear();
  glBindFramebuffer(GL_FRAMEBUFFER, seen_.id());
  attach(GL_COLOR_ATTACHMENT0, seen_texture_, picture_size_);
  check_float_framebuffer();
  for (const int step : kGridSteps) {
    Grid& grid = grids_.emplace_back();
    grid.step = step;
    grid.size = (picture_size_ + (step - 1)) / step + (step > 1 ? 1 : 0);
    attach_airlight(grid, step > 1);
  }
  const glm::ivec2 most_blocks = blocks(grids_.back().size);
  packed_.size = most_blocks * kBlock;
  attach_airlight(packed_, true);
  glBindFramebuffer(GL_FRAMEBUFFER, marks_framebuffer_.id());
  attach(GL_COLOR_ATTACHMENT0, marks_, most_blocks * glm::ivec2(2, 1), GL_RGBA32UI);
  check_float_framebuffer();
  glBindFramebuffer(GL_FRAMEBUFFER, places_framebuffer_.id());
  attach(GL_COLOR_ATTACHMENT0, places_, packed_.size, GL_RG32F);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_STENCIL_ATTACHMENT, GL_RENDERBUFFER, packed_.stencil.id());
  check_float_framebuffer();
}

/// Gives a target of a size its textures and its stencil.
void AirlightPainter::attach_airlight(Target& target, bool has_gain) {
  glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.id());
  attach(GL_COLOR_ATTACHMENT0, target.airlight, target.size);
  if (has_gain) attach(GL_COLOR_ATTACHMENT1, target.gain, target.size);
  glDrawBuffers(has_gain ? 2 : 1, kTargets);
  glBindRenderbuffer(GL_RENDERBUFFER, target.stencil.id());
  glRenderbufferStorage(GL_RENDERBUFFER, GL_STENCIL_INDEX8, target.size.x, target.size.y);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_STENCIL_ATTACHMENT, GL_RENDERBUFFER, target.stencil.id());
  check_float_framebuffer();
}

void AirlightPainter::set_lists(const AirlightList& lights, const AirlightTiles& tiles,
                                const FarAirlightList& far_lights) {
  ranges_ = lights.ranges;
  entries_.reset();
  if (!lights.entries.empty()) {
    entries_.emplace(lights.entries.data(), std::span(lights.entries).size_bytes(), BufferTexture::Texel::float4);
    tile_lists_.emplace(tiles.lists.data(), std::span(tiles.lists).size_bytes(), BufferTexture::Texel::int1);
    tile_count_ = tiles.count;
    tile_size_ = glm::vec2(tiles.size) / glm::vec2(tiles.count);
  }
  far_.set_list(far_lights);
}

void AirlightPainter::draw_far(const View& view, FogMode fog_mode) {
  if (entries_) {
    entries_->bind(kEntryUnit);
    tile_lists_->bind(kTileUnit);
  }
  far_.draw(picture_size_, view, fog_mode);
}

void AirlightPainter::draw(const Framebuffer& framebuffer, const View& view, FogMode fog_mode, double exposure,
                           bool is_seen_by_alpha, Interruption& interruption) {
  if (ranges_.empty() && far_.is_empty()) return;
  const double most_apart = std::max(1.0, kMostApart * view.pixels_per_radian);
  const auto coarsest = std::ranges::find_if(grids_, [&](const Grid& grid) { return grid.step <= most_apart; });
  const std::span<const Grid> grids(coarsest, grids_.end());
  const Frame frame{view, fog_mode, float(std::exp2(exposure)), grids.front().step, interruption};
  glBindVertexArray(vertex_array_.id());
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glClearColor(0, 0, 0, -1);  // alpha: not filled
  framebuffer.bind_depth(kDepthUnit);
  bind_texels(kSeenUnit, seen_texture_);

  glBindFramebuffer(GL_FRAMEBUFFER, seen_.id());
  glViewport(0, 0, picture_size_.x, picture_size_.y);
  use(seen_program_, frame, grids.back());
  glDrawArrays(GL_TRIANGLES, 0, 3);

  for (std::size_t i = 0; i < grids.size() && !interruption.has_come(); ++i) {
    const Grid& grid = grids[i];
    glBindFramebuffer(GL_FRAMEBUFFER, grid.framebuffer.id());
    glClear(GL_COLOR_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    glEnable(GL_STENCIL_TEST);
    if (i > 0) {
      fill(frame, grid, grids[i - 1]);
      draw_left_out(frame, grid);
    }
    draw_packed(frame, grid);
    glDisable(GL_STENCIL_TEST);
    draw_whole(frame, grid);
  }

  glEnable(GL_BLEND);
  glBlendFunc(is_seen_by_alpha ? GL_DST_ALPHA : GL_ONE, GL_ONE);
  framebuffer.bind_resolved();
  add_program_.use();
  bind_texels(kAirlightUnit, grids.back().airlight);
  set_uniform(add_program_, "airlight", kAirlightUnit);
  set_uniform(add_program_, "seen_ranges", kSeenUnit);
  far_.bind(add_program_);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glDisable(GL_BLEND);
}

/// Fills the texels for which the coarser grid is good enough, and marks them.
void AirlightPainter::fill(const Frame& frame, const Grid& grid, const Grid& coarse) {
  glStencilFunc(GL_ALWAYS, kMarked, 0xff);
  glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
  glViewport(0, 0, grid.size.x, grid.size.y);
  use(fill_program_, frame, grid);
  bind_texels(kAirlightUnit, coarse.airlight);
  bind_texels(kGainUnit, coarse.gain);
  set_uniform(fill_program_, "grid", kAirlightUnit);
  set_uniform(fill_program_, "grid_gain", kGainUnit);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
}

/// Draws the lights of a grid at its texels that are not filled: at the first grid all that it has, at others those
/// that the coarser one has. Packed blocks lie apart, as far as the target has room: drivers share a picture out among
/// processors by large tiles, of which a coarse grid fills only one.
void AirlightPainter::draw_packed(const Frame& frame, const Grid& grid) {
  const glm::ivec2 count = blocks(grid.size), room = packed_.size / kBlock;
  const Blocks packed{count, glm::max((room - 1) / glm::max(count - 1, 1), 1), packed_.size, true};
  glBindFramebuffer(GL_FRAMEBUFFER, marks_framebuffer_.id());
  glViewport(0, 0, 2 * count.x, count.y);
  marks_program_.use();
  bind_texels(kAirlightUnit, grid.airlight);
  set_uniform(marks_program_, "airlight", kAirlightUnit);
  glDrawArrays(GL_TRIANGLES, 0, 3);

  bind_texels(kMarkUnit, marks_);
  glBindFramebuffer(GL_FRAMEBUFFER, places_framebuffer_.id());
  glClear(GL_STENCIL_BUFFER_BIT);
  glStencilFunc(GL_ALWAYS, kMarked, 0xff);
  glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
  pack_program_.use();
  set_blocks(pack_program_, packed);
  glDrawArrays(GL_POINTS, 0, count.x * count.y);
  glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);

  glBindFramebuffer(GL_FRAMEBUFFER, packed_.framebuffer.id());
  bind_texels(kPlaceUnit, places_);  // the first range replaces what is there: a clear would cost as much as it draws
  const bool is_coarsest = grid.step == frame.coarsest_step;
  bool has_drawn = false;
  for (std::size_t i = 0; i < ranges_.size(); ++i) {
    const int coarsest = coarsest_step(ranges_[i].kind, frame);
    if (grid.step > coarsest || (!is_coarsest && grid.step == coarsest)) continue;
    draw_lights(frame, grid, i, packed, has_drawn);
    has_drawn = true;
  }
  if (!has_drawn) glClear(GL_COLOR_BUFFER_BIT);

  glBindFramebuffer(GL_FRAMEBUFFER, grid.framebuffer.id());
  glViewport(0, 0, grid.size.x, grid.size.y);
  glStencilFunc(GL_NOTEQUAL, kMarked, 0xff);
  use(unpack_program_, frame, grid);
  bind_texels(kAirlightUnit, packed_.airlight);
  bind_texels(kGainUnit, packed_.gain);
  set_uniform(unpack_program_, "block_marks", kMarkUnit);
  set_uniform(unpack_program_, "packed_airlight", kAirlightUnit);
  set_uniform(unpack_program_, "packed_gain", kGainUnit);
  set_uniform(unpack_program_, "block_stride", packed.stride);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

/// Adds what the coarser grid leaves out of its lights at texels filled from it.
void AirlightPainter::draw_left_out(const Frame& frame, const Grid& grid) {
  glViewport(0, 0, grid.size.x, grid.size.y);
  glStencilFunc(GL_EQUAL, kMarked, 0xff);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  // Texel i's middle is that of pixel i * step.
  const glm::vec2 scale = glm::vec2(picture_size_) / glm::vec2(grid.step * grid.size);
  const glm::vec2 offset = scale - 1.0f + (1.0f - 1.0f / float(grid.step)) / glm::vec2(grid.size);
  for (const auto& [kind, first, count] : ranges_) {
    if (grid.step >= coarsest_step(kind, frame)) continue;
    const gl::Program& program = left_out_programs_.program(frame.fog_mode, kind);
    use(program, frame, grid);
    set_uniform(program, "target_from_picture", glm::vec4(scale, offset));
    set_uniform(program, "first_entry", int(first));
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, GLsizei(count));
  }
  glDisable(GL_BLEND);
}

/// Adds the lights that all coarser grids do without: cookies and shafts are too fine for them.
void AirlightPainter::draw_whole(const Frame& frame, const Grid& grid) {
  if (grid.step == frame.coarsest_step) return;  // which has its lights packed
  const glm::ivec2 count = blocks(grid.size);
  const Blocks whole{count, glm::ivec2(1), count * kBlock, false};
  for (std::size_t i = 0; i < ranges_.size(); ++i) {
    if (grid.step != coarsest_step(ranges_[i].kind, frame)) continue;
    draw_lights(frame, grid, i, whole, true);
  }
}

/// Draws the lights of a range in blocks of the bound framebuffer's texels, which are a grid's own or packed ones: adds
/// them to what is there, or replaces it.
void AirlightPainter::draw_lights(const Frame& frame, const Grid& grid, std::size_t range, const Blocks& blocks,
                                  bool adds) {
  const gl::Program& program = tile_programs_.program(frame.fog_mode, ranges_[range].kind);
  use(program, frame, grid);
  set_uniform(program, "packed_places", kPlaceUnit);
  set_uniform(program, "tile_lists", kTileUnit);
  set_uniform(program, "tile_count", tile_count_);
  set_uniform(program, "tile_size", tile_size_);
  set_uniform(program, "first_tile", int(range) * 2 * tile_count_.x * tile_count_.y);
  set_blocks(program, blocks);
  glStencilFunc(GL_EQUAL, kMarked, 0xff);
  if (adds) glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  const int rows = frame.interruption.can_come() ? (blocks.target.y + kStripes - 1) / kStripes : blocks.target.y;
  glEnable(GL_SCISSOR_TEST);
  for (int row = 0; row < blocks.target.y && !frame.interruption.has_come(); row += rows) {
    glScissor(0, row, blocks.target.x, rows);
    glDrawArrays(GL_POINTS, 0, blocks.count.x * blocks.count.y);
  }
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_BLEND);
}

/// Sets what a program of airlight_blocks.vert needs to draw blocks as points.
void AirlightPainter::set_blocks(const gl::Program& program, const Blocks& blocks) {
  glViewport(0, 0, blocks.target.x, blocks.target.y);
  set_uniform(program, "is_packed", blocks.is_packed);
  set_uniform(program, "block_marks", kMarkUnit);
  set_uniform(program, "block_columns", blocks.count.x);
  set_uniform(program, "block_stride", blocks.stride);
  set_uniform(program, "target_size", glm::vec2(blocks.target));
  glEnable(GL_PROGRAM_POINT_SIZE);
}

/// Pixels between the texels of the first grid that draws lights of a kind.
int AirlightPainter::coarsest_step(const AirlightKind& kind, const Frame& frame) {
  const int smooth_step = kind.profile == kCookieProfile || kind.has_shafts ? 2 : kGridSteps[0];
  return std::min(smooth_step, frame.coarsest_step);
}

void AirlightPainter::use(const gl::Program& program, const Frame& frame, const Grid& grid) {
  program.use();
  bind_lights(program, fog_lights_);
  set_uniform(program, "depths", kDepthUnit);
  set_uniform(program, "seen_ranges", kSeenUnit);
  set_uniform(program, "airlight_entries", kEntryUnit);
  set_uniform(program, "clip_from_world", frame.view.clip_from_world);
  set_uniform(program, "direction_from_clip", frame.view.direction_from_clip);
  set_uniform(program, "pixel_size", 2.0f / glm::vec2(picture_size_));
  set_uniform(program, "eye", frame.view.eye);
  set_uniform(program, "forward", frame.view.forward);
  set_uniform(program, "near_plane", kNearPlane);
  set_fog_top(program, scene_);
  set_uniform(program, "asymmetry", scene::shader_phase_g(scene_));
  set_uniform(program, "shadow_maps", kShadowMapUnit);
  set_uniform(program, "shadow_casters", kShadowCasterUnit);
  set_uniform(program, "caster_of_light", kCasterOfLightUnit);
  set_uniform(program, "exposure_gain", frame.exposure_gain);
  set_uniform(program, "shaft_steps", shaft_steps_);
  set_uniform(program, "pixel_step", grid.step);
}

}  // namespace litfog::render
