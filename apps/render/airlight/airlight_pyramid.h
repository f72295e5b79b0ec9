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
#include "render/gpu/texel_target.h"
#include "render/interruption.h"
#include "render/plan/view.h"
#include "render/render_settings.h"

namespace litfog::render {

/// The airlight of lights within their extents, one pixel a texel. Needs a current GL context.
///
/// Airlight mostly changes slowly over a picture. So all lights are first drawn at every eighth pixel of every eighth
/// row (in small pictures at more), and then in finer and finer grids. A grid leaves out the part of a light's airlight
/// that bends sharply, close to the light. A texel of a finer grid takes the mean of its neighbours in the one before
/// where that is good enough (shaders/airlight/airlight_fill.frag), and only what they have left out is drawn. For the
/// others all lights of their tile are drawn (AirlightTiles), at PackedTexels.
class AirlightPyramid {
 public:
  /// What a picture's airlight depends on, beside the tables of the lights, the cookies and the shadow maps, which
  /// every pass of a frame reads.
  struct Inputs {
    const AirlightLights& lights;
    const SeenRanges& seen;  ///< where rays end; of the pictures' size
    const View& view;
    const Atmosphere& atmosphere;
    double exposure;  ///< EV at which the picture is shown: interpolation may err by an eighth of a step there
  };

  /// fog_lights  has to outlive this
  /// settings    of which the steps of shafts matter
  AirlightPyramid(const gl::FogLightBuffer& fog_lights, const RenderSettings& settings);

  /// Takes another size of the pictures.
  ///
  /// throws  gl::Unsupported where the driver has no float framebuffer of that size
  void set_size(glm::ivec2 picture_size);
  /// Draws the airlight of a picture: its texels are the pixels. After an interruption it draws no more.
  void draw(const Inputs& inputs, Interruption& interruption);
  const gl::TextureName& airlight() const { return grids_.back().airlight; }  ///< rgb, that has been drawn

 private:
  struct Grid : AirlightTarget {
    int step;  // pixels between texels
  };

  /// What the passes of a frame have in common.
  struct Frame {
    const Inputs& inputs;
    int coarsest_step;  // of the grids that the field of view allows
    Interruption& interruption;
  };

  PassTextures use(const gl::Program& program, const Frame& frame, const Grid& grid);
  void fill(const Frame& frame, const Grid& grid, const Grid& coarse);
  void draw_left_out(const Frame& frame, const Grid& grid);
  void draw_packed(const Frame& frame, const Grid& grid);
  void draw_whole(const Frame& frame, const Grid& grid);
  void draw_lights(const Frame& frame, const Grid& grid, std::size_t range, const AirlightBlocks& blocks, bool adds);
  static int coarsest_step(const AirlightKind& kind, const Frame& frame);

  const gl::FogLightBuffer& fog_lights_;
  int shaft_steps_;
  glm::ivec2 picture_size_{0};
  AirlightPrograms tile_programs_;
  AirlightPrograms left_out_programs_;
  gl::Program fill_program_;
  gl::Program unpack_program_;
  TexelPass pass_;
  std::vector<Grid> grids_;  // from coarse to fine
  PackedTexels packed_;
};

}  // namespace litfog::render
