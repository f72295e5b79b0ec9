// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <map>
#include <string>

#include "litfog/atmosphere.h"
#include "litfog/gl/fog_light_buffer.h"
#include "litfog/gl/fog_light_tables.h"
#include "litfog/gl/gl_name.h"
#include "litfog/gl/program.h"
#include "litfog/view_frustum.h"

namespace litfog::gl {

/// The airlight that the lights of tables add beyond their extents, summed once a frame over all of them in a coarse
/// grid of a view, for litfog_far_airlight() of litfog/shaders/far_airlight.glsl. It leaves lights with cookies out.
///
/// error    where extents subtend some rays: mean 1 %, largest 6 % of the brightest sum of a picture; in layers 5 %,
///          15 %                                                                               (far_airlight_test.cpp)
/// threads  like GlName
class FarAirlight {
 public:
  /// grid    rays across and up, each in [2, 512]
  /// throws  std::invalid_argument naming field, value and rule; Unsupported where the driver cannot draw into floats
  explicit FarAirlight(glm::ivec2 grid = {32, 18});

  /// Draws the grid. A vertex array must be bound; no faces may be culled, and the scissor test must be off. Binds the
  /// tables to texture units 14 and 15 and a uniform buffer to binding point 35, which every OpenGL 3.3 has, and leaves
  /// blending off, with other
  /// functions, and unit 15 active. Program, framebuffer and viewport stay as they are. Compiles a program for each fog mode, number of
  /// knots and whether the phase function is isotropic, when it first meets them.
  ///
  /// lights  of the tables, from the first on, of density scales of at least 1: what is far is hidden by such fog
  /// throws  std::invalid_argument naming field, value and rule of the view or the atmosphere
  void draw(const View& view, const Atmosphere& atmosphere, const FogLightTables& tables, std::size_t lights);

  /// Binds the grid to a texture unit, and the program's sampler litfog_far_airlight_grid. The program must be in use.
  void bind(const Program& program, unsigned unit) const;

 private:
  const Program& program_for(const Atmosphere& atmosphere);

  glm::ivec2 size_;
  std::map<std::string, Program> programs_;  // by the constants of an atmosphere
  FogLightBuffer fog_block_;
  TextureName grid_;
  FramebufferName framebuffer_;
};

}  // namespace litfog::gl
