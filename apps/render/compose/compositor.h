// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "litfog/gl/gl_name.h"
#include "litfog/gl/program.h"
#include "render/airlight/airlight_lights.h"
#include "render/airlight/far_airlight.h"
#include "render/airlight/seen_ranges.h"
#include "render/gpu/framebuffer.h"
#include "render/gpu/texel_target.h"

namespace litfog::render {

/// The airlight that each pane draws before itself: it stands before what the pictures' airlight is summed for.
struct PaneAirlight {
  const Phase& phase;
  const AirlightLights& lights;
  const FarAirlight& far;
};

/// Sets what shaders/compose/pane.glsl reads, for the program in use.
///
/// airlight  null: there is none
void bind_pane_airlight(const gl::Program& program, const PaneAirlight* airlight);

/// Composes a picture from what is seen through the fog, panes and airlight, as shaders/compose/compose.glsl states.
/// Between begin_panes() and the end of a frame the framebuffer's alpha is the fraction of the picture behind all panes
/// that is seen through them. Needs a current GL context.
class Compositor {
 public:
  Compositor();

  /// Sets how panes are blended over all that is in the bound framebuffer, even over points before them.
  static void begin_panes();
  static void end_panes();
  /// Adds airlight to a framebuffer that has been resolved. Where panes have been drawn, they let a part of it through.
  ///
  /// airlight  within the lights' extents: AirlightPyramid::airlight()
  /// far       beyond them
  void add_airlight(const Framebuffer& framebuffer, const gl::TextureName& airlight, const FarAirlight& far,
                    const SeenRanges& seen, bool has_panes) const;

 private:
  gl::Program program_;
  TexelPass pass_;
};

}  // namespace litfog::render
