// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "litfog/fog.h"
#include "litfog/gl/program.h"
#include "litfog/shaders/cone_profile.glsl"
#include "scene/scene.h"

namespace litfog::render {

inline constexpr int kCookieProfile = int(LITFOG_PROFILE_COOKIE);  ///< of a light as shaders know it

/// A program for lights of one profile, with or without shafts, in fog of one mode, for a scene where a light has a
/// knee or none has, and that scatters evenly or not: the compiler leaves out what they do not need. Its shaders
/// include airlight_constants.glsl.
gl::Program make_airlight_program(const char* vertex_file, const char* fragment_file, const scene::Scene& scene,
                                  FogMode fog_mode, int profile, bool has_shafts, bool has_knee);

}  // namespace litfog::render
