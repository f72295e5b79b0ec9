// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "measure/triangle_tree.h"
#include "scene/scene.h"

namespace litfog::window {

// How a user moves a camera. Its pitch ends at kSteepest, because a view straight up or down has no up direction.

inline constexpr double kSteepest = 1.5533;  ///< radians, 89 degrees

/// A direction by its heading, to the right of -Z, and its pitch. Radians.
struct Direction {
  double heading;
  double pitch;
};
Direction direction_of(const glm::dvec3& vector);
glm::dvec3 unit_vector(const Direction& direction);

/// Turns the camera about its eye: radians to the right and up. The target keeps its distance.
void look(scene::Camera& camera, double right, double up);

/// Moves eye and target: metres to the right and ahead in the camera's own directions, and up in the world's.
void fly(scene::Camera& camera, double right, double up, double ahead);

/// Rotates eye and target about a point, which keeps its position in the picture: radians to the right and up.
void orbit(scene::Camera& camera, const glm::dvec3& pivot, double right, double up);

/// Multiplies the eye's distance from a point, within [0.1 m, 100 km]. The target is then as far away.
void approach(scene::Camera& camera, const glm::dvec3& pivot, double factor);

/// Undoes a move of the camera that goes through a surface or too near to one.
void stay_before_surfaces(scene::Camera& camera, const scene::Camera& before, const measure::TriangleTree& surfaces);

double target_distance(const scene::Camera& camera);  ///< metres

}  // namespace litfog::window
