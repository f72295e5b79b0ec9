// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <glm/glm.hpp>

#include "scene/camera.h"
#include "scene/mesh.h"

namespace litfog::render {

/// A frame's view, for passes over its pixels.
struct View {
  glm::ivec2 size;  ///< the picture's, pixels
  glm::vec3 eye;    ///< in the shaders' world space: relative to SceneLights::origin()
  glm::vec3 forward;
  glm::mat4 clip_from_world;
  glm::mat4 direction_from_clip;  ///< ray direction from a position in the picture
  double pixels_per_radian;       ///< at the picture's centre
  double top_above_eye;           ///< height of the atmosphere's top above the eye, metres
  bool is_fog_moonlit = false;    ///< is_fog_moonlit() of plan/fog_top.h
  double light_top = 0;           ///< Atmosphere::light_top() in the eye's world space, metres
};

/// Pixels per radian at the centre of a camera's picture.
///
/// height  the picture's, pixels
double pixels_per_radian(const scene::Camera& camera, int height);

/// camera         relative to SceneLights::origin()
/// top_above_eye  height of the atmosphere's top above the eye, metres
View view_of(const scene::Camera& camera, glm::ivec2 size, double top_above_eye);

/// The planes around a camera's view: normal and offset; dot(normal, p) + offset >= 0 inside.
using Frustum = std::array<glm::vec4, 6>;
/// Also valid for clip volumes whose depths begin at 0; there the near plane is conservative.
Frustum make_frustum(const glm::mat4& clip_from_world);

/// Whether the camera can see any part of a box. Conservative: may be true for a box that it cannot see.
bool can_see(const Frustum& frustum, const scene::Bounds& box);

}  // namespace litfog::render
