// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <glm/glm.hpp>

#include "scene/camera.h"
#include "scene/mesh.h"

namespace litfog::render {

/// A frame's view, for passes over its pixels.
struct View {
  glm::ivec2 size;  ///< of the picture, pixels
  glm::vec3 eye;    ///< in world space as shaders take it: relative to SceneLights::origin()
  glm::vec3 forward;
  glm::mat4 clip_from_world;
  glm::mat4 direction_from_clip;  ///< ray direction from a position in the picture
  double pixels_per_radian;       ///< at the picture's middle
  double top_above_eye;           ///< metres: the atmosphere's
  bool is_fog_moonlit = false;    ///< as is_fog_moonlit() of plan/fog_top.h has it
  double light_top = 0;           ///< metres, in world space as the eye: Atmosphere::light_top()
};

/// Pixels per radian at the middle of a camera's picture.
///
/// height  of the picture, pixels
double pixels_per_radian(const scene::Camera& camera, int height);

/// camera         relative to SceneLights::origin()
/// top_above_eye  metres, of the atmosphere
View view_of(const scene::Camera& camera, glm::ivec2 size, double top_above_eye);

/// The planes around a camera's view: normal and offset; dot(normal, p) + offset >= 0 inside.
using Frustum = std::array<glm::vec4, 6>;
/// Also valid for clip volumes whose depths begin at 0, where the near plane is conservative.
Frustum make_frustum(const glm::mat4& clip_from_world);

/// Whether the camera can see anything of a box. Never false where it can; may be true where it cannot.
bool can_see(const Frustum& frustum, const scene::Bounds& box);

}  // namespace litfog::render
