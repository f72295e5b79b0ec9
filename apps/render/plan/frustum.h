// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <glm/glm.hpp>

#include "scene/mesh.h"

namespace litfog::render {

/// The planes of what a camera sees: normal and offset, inside where dot(normal, p) + offset >= 0.
using Frustum = std::array<glm::vec4, 6>;
/// Of a clip volume whose depths begin at -1 or at 0.
Frustum make_frustum(const glm::mat4& clip_from_world);

/// Whether the camera can see anything of a box. Never false where it can; may be true where it cannot.
bool can_see(const Frustum& frustum, const scene::Bounds& box);

}  // namespace litfog::render
