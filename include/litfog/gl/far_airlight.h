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

/// The airlight that the lights of tables add beyond their extents, summed once per frame over all of them in a coarse
/// grid of a view, for litfog_far_airlight() of litfog/shaders/far_airlight.glsl. It leaves out lights with cookies. In
/// fog that scatters forward, such as droplets, it lacks most of the glow within 9 degrees of a lamp, which
/// litfog_far_peak() of the same file adds lamp by lamp.
///
/// error    with litfog_far_peak(), and if extents subtend some rays: mean 1 %, largest 6 % of the brightest sum of a
///          picture; in layers mean 5 %, largest 15 %                                          (far_airlight_test.cpp)
/// threads  like GlName
class FarAirlight {
 public:
  /// After: the grid is bound to the active texture unit.
  ///
  /// grid    number of rays across and up, each in [2, 512]
  /// throws  std::invalid_argument naming field, value and rule; Unsupported if the driver cannot draw into floats
  explicit FarAirlight(glm::ivec2 grid = {32, 18});

  /// Draws the grid. Before: face culling and the scissor test are off, and all colours may be written. After: the
  /// tables are bound to texture units 14 and 15 and a uniform buffer to binding point 35, which every OpenGL 3.3 has;
  /// unit 15 is active; blending is off, with other functions; program, framebuffer, vertex array and viewport are
  /// unchanged. Compiles a program when it first meets a combination of fog mode, number of knots and isotropic or
  /// other phase function.
  ///
  /// lights  number of lights, from the first of the tables; their density scales are at least 1, so that fog hides far
  ///         ones
  /// throws  std::invalid_argument naming field, value and rule of the view or the atmosphere
  void draw(const View& view, const Atmosphere& atmosphere, const FogLightTables& tables, std::size_t lights);

  /// Binds the grid to a texture unit, and sets the program's sampler litfog_far_airlight_grid. The program must be in
  /// use.
  void bind(const Program& program, unsigned unit) const;

 private:
  const Program& program_for(const Atmosphere& atmosphere);

  glm::ivec2 size_;
  std::map<std::string, Program> programs_;  // by the constants of an atmosphere
  FogLightBuffer fog_block_;
  TextureName grid_;
  FramebufferName framebuffer_;
  VertexArrayName no_vertices_;
};

}  // namespace litfog::gl
