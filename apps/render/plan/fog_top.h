// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "litfog/atmosphere.h"
#include "litfog/gl/program.h"
#include "render/plan/view.h"
#include "render/render_settings.h"
#include "scene/scene.h"

namespace litfog::render {

inline constexpr float kSkyDistance = 50'000;  ///< metres: beyond any visibility at which fog is visible

/// Sets the uniforms of shaders/fog_top.glsl in the program in use.
///
/// above_eye  height of the atmosphere's top above the eye, metres
void set_fog_top(const gl::Program& program, double above_eye);

/// Whether a scene's directional light lights its fog, which then also dims it on surfaces: by airlight, in exp fog. In
/// other fog it lights only surfaces, as in clear air.
bool is_fog_moonlit(const scene::Environment& environment, const Atmosphere& atmosphere, FogLighting fog_lighting);

/// Sets the uniforms of shaders/moonlight.glsl in the program in use.
void set_moonlight(const gl::Program& program, const View& view);

}  // namespace litfog::render
