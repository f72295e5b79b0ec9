// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include "scene/scene.h"

namespace litfog::render {

// The depth of a sample is kNearPlane / z, where z is its distance along the camera's axis: 1 at the near plane, 0 at
// infinity. A float has such a depth to half an ulp, which is 2^-24 z at any distance, if the clip volume reaches from
// 0 to 1 (GL_ARB_clip_control). The clip volume of OpenGL 3.3 reaches from -1 to 1, where a distant surface has all but
// -1. Its rounding spans 2^-24 z^2 / kNearPlane: 0.1 m at 400 m, 2.4 m at 2 km.

inline constexpr float kNearPlane = 0.1f;  ///< metres

/// Whether the current context has GL_ARB_clip_control.
bool has_clip_control();

/// Whether the current context's driver shades fewer fragments if they test their depth late (shaders/depth_test.glsl):
/// Mesa's llvmpipe where a pixel has several samples.
bool should_test_depth_late(int samples);

/// What the clip volume of begin_depths() has at infinity.
float far_plane_in_clip();

/// The projection onto that clip volume, for a picture of an aspect ratio.
glm::mat4 clip_from_view(const scene::Camera& camera, double aspect);

/// Sets the current context's clip volume and depth test, and empties the depth buffer of the bound framebuffer.
void begin_depths();
/// Sets clip volume and depth test to OpenGL's defaults.
void end_depths();

}  // namespace litfog::render
