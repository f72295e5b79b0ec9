// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "litfog/fog.h"
#include "litfog/gl/fog_light_buffer.h"
#include "litfog/gl/gl_name.h"
#include "litfog/gl/program.h"
#include "render/airlight_list.h"
#include "render/gpu/framebuffer.h"
#include "render/gpu/texture.h"
#include "render/scene_lights.h"
#include "scene/scene.h"

namespace litfog::render {

/// A frame's view, for passes over its pixels.
struct View {
  glm::mat4 clip_from_world;
  glm::mat4 direction_from_clip;  ///< of the ray through a place on the picture
  float near_plane;               ///< metres
  float fog_above_eye;            ///< metres, finite: shaders/fog_top.glsl
};

/// Adds the airlight of lights over a picture. Needs a current GL context.
///
/// Airlight mostly changes slowly over a picture. So all lights are first drawn at every eighth pixel of every
/// eighth row, and then in finer and finer grids. A grid leaves out the part of a light's airlight that bends sharply,
/// close to the light. A texel of a finer grid takes the mean of its neighbours in the one before where that is good
/// enough (shaders/airlight_fill.frag), and only what they have left out is drawn. Elsewhere all lights are drawn.
class AirlightPainter {
 public:
  /// scene, lights, fog_lights  have to outlive this
  /// framebuffer                of the pictures' size and samples
  /// throws                     gl::Unsupported where the driver has no float framebuffer of their size
  AirlightPainter(const scene::Scene& scene, const SceneLights& lights, const gl::FogLightBuffer& fog_lights,
                  const Framebuffer& framebuffer);

  /// Adds that of all lights to a resolved framebuffer. The lights and the cookies are bound to their units.
  ///
  /// returns  the lights whose airlight it has drawn
  AirlightList draw(const Framebuffer& framebuffer, const View& view, const Fog& fog);

 private:
  /// Airlight at every so many pixels, in floats: half floats would lose what faint lights add to bright ones.
  struct Grid {
    int step;  // pixels
    glm::ivec2 size;
    gl::FramebufferName framebuffer;
    gl::TextureName airlight;
    gl::TextureName gain;  // per opacity of the fog; the finest grid has none
    gl::RenderbufferName stencil;
  };

  /// What the passes of a frame have in common.
  struct Frame {
    const Framebuffer& framebuffer;
    const View& view;
    FogMode fog_mode;
    const std::vector<AirlightList::Range>& lights;
  };

  double pixels_per_radian() const;  ///< at the middle of the picture
  const gl::Program& light_program(FogMode fog_mode, int profile);
  void use(const gl::Program& program, const Frame& frame, const Grid& grid);
  void draw_lights(const Frame& frame, const Grid& grid, bool is_filled);
  void fill(const Frame& frame, const Grid& grid, const Grid& coarse);

  const scene::Scene& scene_;
  const gl::FogLightBuffer& fog_lights_;
  const SceneLights& lights_;
  glm::ivec2 picture_size_;
  /// For lights of one profile in fog of one mode: the compiler leaves out what they do not need.
  std::map<std::pair<FogMode, int>, gl::Program> light_programs_;
  gl::Program seen_program_;
  gl::Program fill_program_;
  gl::Program add_program_;
  gl::FramebufferName seen_;
  gl::TextureName seen_texture_;
  std::vector<Grid> grids_;           // from coarse to fine
  std::optional<BufferTexture> entries_;  // of the light list
  gl::VertexArrayName vertex_array_;  // of no attributes
};

}  // namespace litfog::render
