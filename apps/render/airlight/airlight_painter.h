// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "litfog/fog.h"
#include "litfog/gl/fog_light_buffer.h"
#include "litfog/gl/gl_name.h"
#include "litfog/gl/program.h"
#include "render/airlight/airlight_list.h"
#include "render/airlight/airlight_programs.h"
#include "render/airlight/airlight_tiles.h"
#include "render/airlight/far_airlight.h"
#include "render/gpu/data_texture.h"
#include "render/gpu/framebuffer.h"
#include "render/interruption.h"
#include "render/plan/view.h"
#include "render/render_settings.h"
#include "scene/scene.h"

namespace litfog::render {

/// Adds the airlight of lights over a picture. Needs a current GL context.
///
/// Airlight mostly changes slowly over a picture. So all lights are first drawn at every eighth pixel of every eighth
/// row (of small pictures at more), and then in finer and finer grids. A grid leaves out the part of a light's airlight
/// that bends sharply, close to the light. A texel of a finer grid takes the mean of its neighbours in the one before
/// where that is good enough (shaders/airlight_fill.frag), and only what they have left out is drawn. For the others
/// all lights of their tile are drawn (AirlightTiles), at texels packed into a target of their own.
class AirlightPainter {
 public:
  /// scene, fog_lights  have to outlive this
  /// framebuffer        of the pictures' size and samples
  /// settings           of which the steps of shafts matter
  /// throws             gl::Unsupported where the driver has no float framebuffer of their size
  AirlightPainter(const scene::Scene& scene, const gl::FogLightBuffer& fog_lights, const Framebuffer& framebuffer,
                  const RenderSettings& settings);

  /// Takes another size of the pictures, which have as many samples as before.
  void set_size(const Framebuffer& framebuffer);

  /// Uploads the lights whose airlight frames have from now on, within their extents and beyond.
  void set_lists(const AirlightList& lights, const AirlightTiles& tiles, const FarAirlightList& far_lights);
  /// Binds the lists of set_lists() for draw(), and sums up what lights add beyond their extents. The caller has bound
  /// the lights' tables and the cookies.
  void draw_far(const View& view, FogMode fog_mode);
  /// What draw_far() has summed up, for panes.
  const FarAirlight& far() const { return far_; }
  /// Adds the airlight of all lights to a resolved framebuffer. draw_far() comes first; its bindings have to hold
  /// still.
  ///
  /// exposure          EV at which the picture is shown: interpolation may err by an eighth of a step there
  /// is_seen_by_alpha  the framebuffer's alpha is the fraction of it that is seen
  /// interruption      after which it draws no more
  void draw(const Framebuffer& framebuffer, const View& view, FogMode fog_mode, double exposure, bool is_seen_by_alpha,
            Interruption& interruption);

 private:
  /// Airlight in floats: half floats would lose what faint lights add to bright ones.
  struct Target {
    glm::ivec2 size;
    gl::FramebufferName framebuffer;
    gl::TextureName airlight;
    gl::TextureName gain;  // per opacity of the fog; the finest grid has none
    gl::RenderbufferName stencil;
  };

  struct Grid : Target {
    int step;  // pixels between texels
  };

  /// Some of a target's blocks of texels (shaders/airlight_blocks.glsl).
  struct Blocks {
    glm::ivec2 count;
    glm::ivec2 stride;  // from one to the next, in blocks
    glm::ivec2 target;  // texels
    bool is_packed;
  };

  /// What the passes of a frame have in common.
  struct Frame {
    const View& view;
    FogMode fog_mode;
    float exposure_gain;
    int coarsest_step;  // of the grids that the field of view allows
    Interruption& interruption;
  };

  void attach_airlight(Target& target, bool has_gain);
  void use(const gl::Program& program, const Frame& frame, const Grid& grid);
  void fill(const Frame& frame, const Grid& grid, const Grid& coarse);
  void draw_left_out(const Frame& frame, const Grid& grid);
  void draw_packed(const Frame& frame, const Grid& grid);
  void draw_whole(const Frame& frame, const Grid& grid);
  void draw_lights(const Frame& frame, const Grid& grid, std::size_t range, const Blocks& blocks, bool adds);
  static void set_blocks(const gl::Program& program, const Blocks& blocks);
  static int coarsest_step(const AirlightKind& kind, const Frame& frame);

  const scene::Scene& scene_;
  const gl::FogLightBuffer& fog_lights_;
  FarAirlight far_;
  glm::ivec2 picture_size_;
  int shaft_steps_;
  AirlightPrograms tile_programs_;
  AirlightPrograms left_out_programs_;
  gl::Program seen_program_;
  gl::Program fill_program_;
  gl::Program marks_program_;
  gl::Program pack_program_;
  gl::Program unpack_program_;
  gl::Program add_program_;
  gl::FramebufferName seen_;
  gl::TextureName seen_texture_;
  std::vector<Grid> grids_;  // from coarse to fine
  Target packed_;            // texels that a grid does not fill, packed (shaders/airlight_blocks.glsl)
  gl::FramebufferName marks_framebuffer_;
  gl::TextureName marks_;  // of those texels
  gl::FramebufferName places_framebuffer_;
  gl::TextureName places_;                   // of those texels in their grid
  std::vector<AirlightList::Range> ranges_;  // of the lights
  std::optional<BufferTexture> entries_;     // likewise
  std::optional<BufferTexture> tile_lists_;  // AirlightTiles::lists
  glm::ivec2 tile_count_{0};
  glm::vec2 tile_size_{0};            // pixels
  gl::VertexArrayName vertex_array_;  // of no attributes
};

}  // namespace litfog::render
