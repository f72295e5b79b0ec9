// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <glm/glm.hpp>

#include "scene/mesh.h"

namespace litfog::render {

/// The planes around a camera's view: normal and offset; dot(normal, p) + offset >= 0 inside.
using Frustum = std::array<glm::vec4, 6>;
/// Also valid for clip volumes whose depths begin at 0, where the near plane is conservative.
Frustum make_frustum(const glm::mat4& clip_from_world);

/// Whether the camera can see anything of a box. Never false where it can; may be true where it cannot.
bool can_see(const Frustum& frustum, const scene::Bounds& box);

}  // namespace litfog::render
