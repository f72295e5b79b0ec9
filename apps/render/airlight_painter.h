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
class AirlightPainter {
 public:
  /// scene, fog_lights  have to outlive this
  AirlightPainter(const scene::Scene& scene, const gl::FogLightBuffer& fog_lights);

  /// Adds that of all lights in the light list to a resolved framebuffer. The list, the lights and the cookies are bound
  /// to their units.
  void draw(const Framebuffer& framebuffer, const View& view, unsigned lights, unsigned carried);

 private:
  const scene::Scene& scene_;
  const gl::FogLightBuffer& fog_lights_;
  gl::Program program_;
  gl::VertexArrayName vertex_array_;  // of no attributes
};

}  // namespace litfog::render
