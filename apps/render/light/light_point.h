// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "litfog/gl/program.h"
#include "render/plan/view.h"
#include "render/render_settings.h"

namespace litfog::render {

/// The shaders that draw lights as points: by peak with glare, by airlight as discs of their source radii.
struct PointShaders {
  const char* vertex;
  const char* fragment;
};
PointShaders point_shaders(FogLighting fog_lighting);

/// Draws lights as points over the picture with the program in use, one of point_shaders() whose light tables are
/// bound.
///
/// first, count  entries of the light list
void draw_light_points(const gl::Program& program, const View& view, FogLighting fog_lighting, int first, int count);

}  // namespace litfog::render
