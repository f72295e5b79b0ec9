// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include "scene/scene.h"

namespace litfog::render {

// The depth of a sample is kNearPlane / z, where z is its distance along the camera's axis: 1 at the near plane, 0 at
// infinity. If the clip volume reaches from 0 to 1 (GL_ARB_clip_control), a float rounds this depth by half an ulp,
// which is 2^-24 z at any distance. The clip volume of OpenGL 3.3 reaches from -1 to 1, where a distant surface lies
// close to -1. There the rounding spans 2^-24 z^2 / kNearPlane: 0.1 m at 400 m, 2.4 m at 2 km.

inline constexpr float kNearPlane = 0.1f;  ///< metres

/// Whether the current context has GL_ARB_clip_control.
bool has_clip_control();

/// Whether the current driver shades fewer fragments if shaders test the depth late (shaders/depth_test.glsl). Mesa's
/// llvmpipe does with several samples a pixel.
bool should_test_depth_late(int samples);

/// The clip-space depth of infinity in the clip volume of begin_depths().
float far_plane_in_clip();

/// The projection onto the clip volume of begin_depths(), for an aspect of width over height.
glm::mat4 clip_from_view(const scene::Camera& camera, double aspect);

/// Sets the current context's clip volume and depth test, and empties the depth buffer of the bound framebuffer.
void begin_depths();
/// Sets clip volume and depth test to OpenGL's defaults.
void end_depths();

}  // namespace litfog::render
