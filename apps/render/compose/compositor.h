// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "litfog/gl/gl_name.h"
#include "litfog/gl/program.h"
#include "render/airlight/airlight_lights.h"
#include "render/airlight/far_airlight.h"
#include "render/airlight/seen_ranges.h"
#include "render/gpu/framebuffer.h"
#include "render/gpu/texel_target.h"
#include "render/plan/view.h"

namespace litfog::render {

/// The airlight between the eye and a pane. Each pane draws its own, because the picture's airlight ends behind panes.
struct PaneAirlight {
  const AirlightLights& lights;
  const FarAirlight& far;
};

/// Sets the uniforms of shaders/compose/pane.glsl in the program in use.
///
/// airlight  null: there is none
void bind_pane_airlight(const gl::Program& program, const PaneAirlight* airlight);

/// Composes a picture from surfaces in fog, panes and airlight, as shaders/compose/compose.glsl states. From
/// begin_panes() to the end of a frame the framebuffer's alpha is the fraction of the light behind all panes that
/// passes through them. Needs a current GL context.
class Compositor {
 public:
  Compositor();

  /// Sets the blending of panes: over everything in the bound framebuffer, even over points before them.
  static void begin_panes();
  static void end_panes();
  /// Adds airlight to a resolved framebuffer, dimmed by the panes that have been drawn.
  ///
  /// airlight  within the lights' extents: AirlightPyramid::airlight()
  /// far       beyond the lights' extents
  void add_airlight(const Framebuffer& framebuffer, const gl::TextureName& airlight, const FarAirlight& far,
                    const SeenRanges& seen, const View& view, bool has_panes) const;

 private:
  gl::Program program_;
  TexelPass pass_;
};

}  // namespace litfog::render
