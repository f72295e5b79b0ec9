// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

#include "scene/mesh.h"

namespace litfog::scene {

/// A hole in a wall: a window, door or niche, from (left, bottom) to (right, top), metres on the wall.
struct Opening {
  float left, bottom, right, top;
};

/// A wall from (0, 0) to (width, height) in the plane z = 0, seen from +Z, with openings whose sides go back to
/// z = -depth. Openings lie inside the wall and do not overlap.
Mesh make_wall(float width, float height, std::span<const Opening> openings, float depth);

/// The depth of an opening with a window or door in it.
inline constexpr float kReveal_m = 0.18f;

/// Fills an opening of that depth with a frame, glazing bars, a pane and a sill.
void add_window(Model& model, const Opening& opening, const glm::mat4& model_from_wall, bool lit);

/// Fills an opening of that depth with a panelled door.
void add_door(Model& model, const Opening& opening, const glm::mat4& model_from_wall, std::string_view paint);

}  // namespace litfog::scene
