// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "litfog/atmosphere.h"
#include "litfog/gl/fog_light_buffer.h"
#include "litfog/gl/gl_name.h"
#include "litfog/gl/program.h"
#include "render/airlight/airlight_programs.h"
#include "render/airlight/far_airlight_list.h"
#include "render/gpu/data_texture.h"
#include "render/gpu/pass_textures.h"
#include "render/gpu/texel_target.h"
#include "render/plan/view.h"

namespace litfog::render {

/// Draws the airlight of lights beyond their extents. One light's is faint, but hundreds in view brighten pictures by
/// tens of steps of the display. This airlight varies slowly over a picture and along its rays, so that all lights are
/// summed at once, in slabs of rays 0.03 radians apart (shaders/airlight/far_airlight.frag), between which pixels
/// interpolate. Needs a current GL context.
class FarAirlight {
 public:
  /// fog_lights  has to outlive this
  explicit FarAirlight(const gl::FogLightBuffer& fog_lights)
      : fog_lights_(fog_lights), light_programs_("whole_picture.vert", "airlight/far_airlight.frag") {}

  /// Uploads the lights of the next frames.
  ///
  /// higher_orders  have to outlive this or the next call
  void set_list(const FarAirlightList& list, const HigherOrderTextures& higher_orders);
  /// Sums the airlight for a frame. Lights and cookies must be bound to their units.
  ///
  /// throws  gl::Unsupported where the driver cannot draw into textures of floats
  void draw(glm::ivec2 picture_size, const View& view, const Atmosphere& atmosphere);

  bool is_empty() const { return depth_ == 0; }
  double depth() const { return depth_; }  ///< FarAirlightList::depth
  /// Lets a pass read the list's lights as far_lights. Returns their number. The list may not be empty.
  int bind_list(PassTextures& textures) const;
  /// Lets the program in use, one that includes far_airlight_at.glsl, look up what has been drawn.
  void bind(const gl::Program& program, PassTextures& textures) const;

 private:
  void set_size(glm::ivec2 size);

  const gl::FogLightBuffer& fog_lights_;
  double depth_ = 0;
  float visible_step_ = 0;
  int light_count_ = 0;
  int step_ = 1;  // pixels between texels
  glm::ivec2 size_{0};
  std::vector<FarAirlightList::Range> ranges_;
  std::optional<BufferTexture> listed_;
  const HigherOrderTextures* higher_orders_ = nullptr;
  AirlightPrograms light_programs_;
  std::optional<gl::Program> sum_program_;
  gl::FramebufferName slabs_framebuffer_;
  gl::TextureName slabs_;
  gl::FramebufferName sums_framebuffer_;
  gl::TextureName sums_;
  TexelPass pass_;
};

}  // namespace litfog::render
