// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include "litfog/gl/fog_light_buffer.h"
#include "litfog/gl/gl_name.h"
#include "render/airlight/airlight_programs.h"
#include "render/airlight/far_airlight.h"
#include "render/airlight/higher_orders.h"
#include "render/gpu/pass_textures.h"
#include "render/gpu/texel_target.h"
#include "render/plan/view.h"

namespace litfog::render {

/// The light that fog scatters on surfaces, of all lamps together, at the texels of a coarse grid over the picture and
/// along its rays, between which surfaces interpolate (shaders/airlight/scattered_light.frag). Walls do not stop it.
/// Needs a current GL context.
class ScatteredLight {
 public:
  /// fog_lights  has to outlive this
  explicit ScatteredLight(const gl::FogLightBuffer& fog_lights)
      : fog_lights_(fog_lights), programs_("whole_picture.vert", "airlight/scattered_light.frag") {}

  /// Sums the light for a frame. Lights must be bound to their units.
  ///
  /// far            whose lights these are, and whose depth the grid has
  /// higher_orders  of the lights; empty: there is no such light
  /// throws         gl::Unsupported where the driver cannot draw into textures of floats
  void draw(glm::ivec2 picture_size, const View& view, const Atmosphere& atmosphere, const FarAirlight& far,
            const HigherOrderTextures& higher_orders);

  /// Lets the program in use, one that includes scattered_light.glsl, look up what has been drawn.
  void bind(const gl::Program& program) const;

 private:
  void set_size(glm::ivec3 size);

  const gl::FogLightBuffer& fog_lights_;
  float depth_ = 0;  // metres along a ray that the grid covers; 0: there is no light
  glm::vec2 picture_size_{1};
  glm::ivec3 size_{0};  // texels
  AirlightPrograms programs_;
  gl::FramebufferName framebuffer_;
  gl::TextureName all_, flow_;
  TexelPass pass_;
};

}  // namespace litfog::render
