// SPDX-License-Identifier: Apache-2.0
#include "render/airlight/airlight_pyramid.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "render/gpu/light_uniforms.h"
#include "render/gpu/render_shaders.h"

namespace litfog::render {
namespace {

constexpr int kStripes = 16;                            // per target; interruptions are polled between them
/// Lights that a fragment adds up in one draw. Mesa's llvmpipe ends a fragment's loops, without a word, after 65535
/// turns of all together (LP_MAX_TGSI_LOOP_ITERATIONS), and for each of four depths a light may take some 300 nodes, a
/// cookie 1000.
constexpr int kLightsAtOnce = 32;
constexpr int kCookiesAtOnce = 16;
constexpr int kGridSteps[] = {kCoarsestGrid, 4, 2, 1};  // pixels
constexpr double kMaxSpacing = 0.06;  // radians between a grid's texels, up to which airlight is known to be smooth
constexpr GLint kMarked = AirlightTarget::kMarked;

}  // namespace

AirlightPyramid::AirlightPyramid(const gl::FogLightBuffer& fog_lights, const SamplerStates& states,
                                 const RenderSettings& settings)
    : fog_lights_(fog_lights),
      sampler_states_(states),
      shaft_steps_(settings.shaft_steps),
      light_programs_("airlight/airlight_lights.vert", "airlight/airlight_lights.frag"),
      fill_program_("whole_picture.vert", "airlight/airlight_fill.frag", render_shaders()),
      unpack_program_("whole_picture.vert", "airlight/airlight_unpack.frag", render_shaders()) {}

void AirlightPyramid::set_size(glm::ivec2 picture_size) {
  picture_size_ = picture_size;
  grids_.clear();
  for (const int step : kGridSteps) {
    Grid& grid = grids_.emplace_back();
    grid.step = step;
    grid.set_size((picture_size + (step - 1)) / step + (step > 1 ? 1 : 0));
  }
  packed_.set_size(grids_.back().size);
}

void AirlightPyramid::draw(const Inputs& inputs, Interruption& interruption) {
  const double max_step = std::max(1.0, kMaxSpacing * inputs.view.pixels_per_radian);
  const auto coarsest = std::ranges::find_if(grids_, [&](const Grid& grid) { return grid.step <= max_step; });
  const std::span<const Grid> grids(coarsest, grids_.end());
  const Frame frame{inputs, grids.front().step, interruption};
  pass_.begin();
  glClearColor(0, 0, 0, AirlightTarget::kNotFilled);
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
}

/// Fills the texels for which the coarser grid is good enough, and marks them.
void AirlightPyramid::fill(const Frame& frame, const Grid& grid, const Grid& coarse) {
  glStencilFunc(GL_ALWAYS, kMarked, 0xff);
  glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
  glViewport(0, 0, grid.size.x, grid.size.y);
  PassTextures textures = use(fill_program_, frame, grid);
  textures.bind("grid", coarse.airlight, GL_TEXTURE_RECTANGLE);
  textures.bind("grid_gain", coarse.gain, GL_TEXTURE_RECTANGLE);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
}

/// Draws lights at a grid's texels that are not filled: in the first grid all its lights, in others those of the
/// coarser grid.
void AirlightPyramid::draw_packed(const Frame& frame, const Grid& grid) {
  const AirlightBlocks blocks = packed_.pack(grid);
  // The first range replaces what is there: a clear would cost as much as it draws.
  glBindFramebuffer(GL_FRAMEBUFFER, packed_.target().framebuffer.id());
  const std::span<const AirlightList::Range> ranges = frame.inputs.lights.ranges();
  const bool is_coarsest = grid.step == frame.coarsest_step;
  bool has_drawn = false;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const int coarsest = coarsest_step(ranges[i].kind, frame);
    if (grid.step > coarsest || (!is_coarsest && grid.step == coarsest)) continue;
    draw_lights(frame, grid, i, blocks, has_drawn);
    has_drawn = true;
  }
  if (!has_drawn) glClear(GL_COLOR_BUFFER_BIT);

  glBindFramebuffer(GL_FRAMEBUFFER, grid.framebuffer.id());
  glViewport(0, 0, grid.size.x, grid.size.y);
  glStencilFunc(GL_NOTEQUAL, kMarked, 0xff);
  PassTextures textures = use(unpack_program_, frame, grid);
  packed_.bind_packed(unpack_program_, textures, blocks);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

/// Adds, at texels filled from the coarser grid, what that grid leaves out of its lights.
void AirlightPyramid::draw_left_out(const Frame& frame, const Grid& grid) {
  glViewport(0, 0, grid.size.x, grid.size.y);
  glStencilFunc(GL_EQUAL, kMarked, 0xff);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  // Texel i's middle is that of pixel i * step.
  const glm::vec2 scale = glm::vec2(picture_size_) / glm::vec2(grid.step * grid.size);
  const glm::vec2 offset = scale - 1.0f + (1.0f - 1.0f / float(grid.step)) / glm::vec2(grid.size);
  for (const auto& [kind, first, count] : frame.inputs.lights.ranges()) {
    if (grid.step >= coarsest_step(kind, frame)) continue;
    const gl::Program& program = light_programs_.program(frame.inputs.atmosphere, kind);
    use_for_lights(program, frame, grid);
    set_uniform(program, "is_left_out", true);
    set_uniform(program, "is_packed", false);
    set_uniform(program, "clip_from_world", frame.inputs.view.clip_from_world);
    set_uniform(program, "target_from_picture", glm::vec4(scale, offset));
    set_uniform(program, "first_entry", int(first));
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, GLsizei(count));
  }
  glDisable(GL_BLEND);
}

/// Adds the lights that all coarser grids lack, because cookies and shafts are too fine for them.
void AirlightPyramid::draw_whole(const Frame& frame, const Grid& grid) {
  if (grid.step == frame.coarsest_step) return;  // draw_packed() draws its lights
  const std::span<const AirlightList::Range> ranges = frame.inputs.lights.ranges();
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    if (grid.step != coarsest_step(ranges[i].kind, frame)) continue;
    draw_lights(frame, grid, i, AirlightBlocks::all_of(grid), true);
  }
}

/// Draws the lights of a range in blocks of the bound framebuffer's texels, adding to them or replacing them.
void AirlightPyramid::draw_lights(const Frame& frame, const Grid& grid, std::size_t range, const AirlightBlocks& blocks,
                                  bool adds) {
  const AirlightLights& lights = frame.inputs.lights;
  const gl::Program& program = light_programs_.program(frame.inputs.atmosphere, lights.ranges()[range].kind);
  PassTextures textures = use_for_lights(program, frame, grid);
  lights.bind_tiles(program, textures, range);
  set_uniform(program, "is_left_out", false);
  blocks.set(program);
  glStencilFunc(GL_EQUAL, kMarked, 0xff);
  if (adds) glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  const int rows = frame.interruption.can_come() ? (blocks.target.y + kStripes - 1) / kStripes : blocks.target.y;
  const int at_once = lights.ranges()[range].kind.profile == kCookieProfile ? kCookiesAtOnce : kLightsAtOnce;
  set_uniform(program, "entry_count", at_once);
  glEnable(GL_SCISSOR_TEST);
  for (int entry = 0; entry < std::max(lights.longest_list(range), 1); entry += at_once) {
    set_uniform(program, "first_entry", entry);
    for (int row = 0; row < blocks.target.y && !frame.interruption.has_come(); row += rows) {
      glScissor(0, row, blocks.target.x, rows);
      glDrawArrays(GL_POINTS, 0, blocks.count.x * blocks.count.y);
    }
    glEnable(GL_BLEND);  // the next ones are added
  }
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_BLEND);
}

/// Pixels between texels of the first grid that draws lights of a kind.
int AirlightPyramid::coarsest_step(const AirlightKind& kind, const Frame& frame) {
  const int smooth_step = kind.profile == kCookieProfile || kind.has_shafts ? 2 : kGridSteps[0];
  return std::min(smooth_step, frame.coarsest_step);
}

/// Sets what all passes over a grid read.
PassTextures AirlightPyramid::use(const gl::Program& program, const Frame& frame, const Grid& grid) {
  program.use();
  bind_lights(program, fog_lights_);
  set_uniform(program, "shadow_maps", kShadowMapUnit);
  set_uniform(program, "shadow_casters", kShadowCasterUnit);
  set_uniform(program, "caster_of_light", kCasterOfLightUnit);
  set_uniform(program, "shaft_steps", shaft_steps_);
  set_uniform(program, "eye", frame.inputs.view.eye);
  set_uniform(program, "direction_from_clip", frame.inputs.view.direction_from_clip);
  set_uniform(program, "pixel_size", 2.0f / glm::vec2(picture_size_));
  set_uniform(program, "exposure_gain", float(std::exp2(frame.inputs.exposure)));
  set_uniform(program, "pixel_step", grid.step);
  PassTextures textures(program);
  frame.inputs.seen.bind(textures);
  return textures;
}

/// Sets what a program of light_programs_ reads as well.
PassTextures AirlightPyramid::use_for_lights(const gl::Program& program, const Frame& frame, const Grid& grid) {
  sampler_states_.set();
  PassTextures textures = use(program, frame, grid);
  packed_.bind_positions(textures);
  frame.inputs.higher_orders.bind(textures);
  frame.inputs.lights.bind_entries(textures);
  return textures;
}

}  // namespace litfog::render
