// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "litfog/gl/program.h"
#include "render/render_settings.h"

namespace litfog::render {

/// Passes the program in use, one of shaders/light_point.vert, how points are drawn, but for the view and the lights.
///
/// height            of the picture, pixels
/// has_clip_control  whether depths have the precision of gpu/depth.h's clip control
void set_point_uniforms(const gl::Program& program, FogLighting fog_lighting, int height, bool has_clip_control);

}  // namespace litfog::render
