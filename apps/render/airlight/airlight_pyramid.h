// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "litfog/atmosphere.h"
#include "litfog/gl/fog_light_buffer.h"
#include "litfog/gl/gl_name.h"
#include "litfog/gl/program.h"
#include "render/airlight/airlight_lights.h"
#include "render/airlight/airlight_programs.h"
#include "render/airlight/packed_texels.h"
#include "render/airlight/seen_ranges.h"
#include "render/gpu/sampler_states.h"
#include "render/gpu/texel_target.h"
#include "render/interruption.h"
#include "render/plan/view.h"
#include "render/render_settings.h"

namespace litfog::render {

/// Draws the airlight of lights within their extents, one texel a pixel. Needs a current GL context.
///
/// Airlight mostly changes slowly over a picture. So all lights are first drawn into a grid of every eighth pixel of
/// every eighth row (of more in small pictures), and then in finer and finer grids. A grid leaves out the part of a
/// light's airlight that bends sharply, close to the light. Where it is accurate enough, a texel of a finer grid is the
/// mean of its neighbours in the coarser grid (shaders/airlight/airlight_fill.frag), to which only the parts left out
/// by the coarser grid are added. At all other texels, packed by PackedTexels, all lights of their tile are drawn
/// (AirlightTiles).
class AirlightPyramid {
 public:
  /// What a picture's airlight depends on, beside the light tables, cookies and shadow maps that every pass reads.
  struct Inputs {
    const AirlightLights& lights;
    const HigherOrderTextures& higher_orders;
    const SeenRanges& seen;  ///< where rays end, at the pictures' size
    const View& view;
    const Atmosphere& atmosphere;
    double exposure;  ///< EV at which the picture is shown: interpolation may err by an eighth of a step there
  };

  /// fog_lights, states  have to outlive this
  /// settings            of which the steps of shafts matter
  AirlightPyramid(const gl::FogLightBuffer& fog_lights, const SamplerStates& states, const RenderSettings& settings);

  /// Sets the size of the pictures.
  ///
  /// throws  gl::Unsupported where the driver has no float framebuffer of that size
  void set_size(glm::ivec2 picture_size);
  /// Draws the airlight of a picture. Stops at an interruption.
  void draw(const Inputs& inputs, Interruption& interruption);
  const gl::TextureName& airlight() const { return grids_.back().airlight; }  ///< rgb; a texel is a pixel

 private:
  struct Grid : AirlightTarget {
    int step;  // pixels between texels
  };

  /// State that the passes of a frame share.
  struct Frame {
    const Inputs& inputs;
    int coarsest_step;  // pixels between texels of the coarsest grid that the field of view allows
    Interruption& interruption;
  };

  PassTextures use(const gl::Program& program, const Frame& frame, const Grid& grid);
  PassTextures use_for_lights(const gl::Program& program, const Frame& frame, const Grid& grid);
  void fill(const Frame& frame, const Grid& grid, const Grid& coarse);
  void draw_left_out(const Frame& frame, const Grid& grid);
  void draw_packed(const Frame& frame, const Grid& grid);
  void draw_whole(const Frame& frame, const Grid& grid);
  void draw_lights(const Frame& frame, const Grid& grid, std::size_t range, const AirlightBlocks& blocks, bool adds);
  static int coarsest_step(const AirlightKind& kind, const Frame& frame);

  const gl::FogLightBuffer& fog_lights_;
  const SamplerStates& sampler_states_;
  int shaft_steps_;
  glm::ivec2 picture_size_{0};
  AirlightPrograms light_programs_;
  gl::Program fill_program_;
  gl::Program unpack_program_;
  TexelPass pass_;
  std::vector<Grid> grids_;  // from coarse to fine
  PackedTexels packed_;
};

}  // namespace litfog::render
