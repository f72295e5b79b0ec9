// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "litfog/atmosphere.h"
#include "litfog/gl/program.h"
#include "render/plan/view.h"
#include "render/render_settings.h"
#include "scene/scene.h"

namespace litfog::render {

inline constexpr float kSkyDistance = 50'000;  ///< metres: beyond any visibility at which fog is visible

/// Passes the program in use, one of shaders/fog_top.glsl, where the fog ends.
///
/// above_eye  metres, of the atmosphere's top
void set_fog_top(const gl::Program& program, double above_eye);

/// Whether a scene's directional light lights its fog, which then dims it on surfaces, too: by airlight, in exp fog. In
/// other fog it lights surfaces alone, as in clear air.
bool is_fog_moonlit(const scene::Environment& environment, const Atmosphere& atmosphere, FogLighting fog_lighting);

/// Passes the program in use, one of shaders/moonlight.glsl, whether the fog is lit so, and from where.
void set_moonlight(const gl::Program& program, const View& view);

}  // namespace litfog::render
