// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <utility>

#include "litfog/gl/fog_light_buffer.h"
#include "litfog/gl/program.h"
#include "render/plan/frame_counts.h"
#include "render/plan/view.h"
#include "scene/scene.h"

namespace litfog::render {

/// Draws the sky behind the framebuffer's contents. The program in use has shaders/sky.vert and can read the fog.
void draw_sky(const gl::Program& program, const View& view, const scene::Scene& scene);

/// Draws the sky through the fog, which carried lights light. Needs a current GL context.
class SkyPainter {
 public:
  /// scene, fog_lights  must outlive this object
  SkyPainter(const scene::Scene& scene, const gl::FogLightBuffer& fog_lights)
      : scene_(scene), fog_lights_(fog_lights) {}

  /// Light tables, the frame's light list and cookies must be bound to their units.
  ///
  /// carried_count  number of carried lights, the first ones of the light list
  void draw(const View& view, SkyDrawing drawing, std::size_t carried_count);

 private:
  const gl::Program& program(SkyDrawing drawing, bool is_lit);

  const scene::Scene& scene_;
  const gl::FogLightBuffer& fog_lights_;
  std::map<std::pair<SkyDrawing, bool>, gl::Program> programs_;  // compiled on first use
};

}  // namespace litfog::render
