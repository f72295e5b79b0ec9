// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "litfog/gl/program.h"

namespace litfog::render {

inline constexpr float kSkyDistance = 50'000;  ///< metres: beyond any visibility at which fog is visible

/// Passes the program in use, one of shaders/fog_top.glsl, where the fog ends.
///
/// above_eye  metres, of the atmosphere's top
void set_fog_top(const gl::Program& program, double above_eye);

}  // namespace litfog::render
