// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include "litfog/gl/fog_light_buffer.h"
#include "litfog/gl/gl_name.h"
#include "litfog/gl/program.h"
#include "render/gpu/framebuffer.h"
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
/// Airlight mostly changes slowly over a picture. So all lights are first drawn at every fourth pixel of every fourth
/// row. Pixels between four such texels that differ little take their mean; the others, and those close to a light, are
/// drawn light by light (shaders/airlight_fill.frag).
class AirlightPainter {
 public:
  /// scene, fog_lights  have to outlive this
  /// framebuffer        of the pictures' size and samples
  /// throws             gl::Unsupported where the driver has no float framebuffer of their size
  AirlightPainter(const scene::Scene& scene, const gl::FogLightBuffer& fog_lights, const Framebuffer& framebuffer);

  /// Adds that of all lights in the light list to a resolved framebuffer. The list, the lights and the cookies are bound
  /// to their units.
  void draw(const Framebuffer& framebuffer, const View& view, unsigned lights, unsigned carried);

 private:
  void use(const gl::Program& program, const Framebuffer& framebuffer, const View& view, unsigned carried);

  const scene::Scene& scene_;
  const gl::FogLightBuffer& fog_lights_;
  glm::ivec2 picture_size_;
  glm::ivec2 grid_size_;
  gl::Program light_program_;
  gl::Program core_program_;
  gl::Program fill_program_;
  gl::Program add_program_;
  gl::FramebufferName grid_;
  gl::TextureName grid_texture_;
  gl::FramebufferName sum_;  // in floats: half floats would lose what faint lights add to bright ones
  gl::TextureName sum_texture_;
  gl::RenderbufferName sum_stencil_;
  gl::VertexArrayName vertex_array_;  // of no attributes
};

}  // namespace litfog::render
