// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "scene/model/parameter_list.h"

namespace litfog::scene {

/// The centre line of a road, which everything beside the road follows: from the origin towards -Z, a parabola that has
/// left the -Z axis by `bend_m` (to +X, the right) at its end.
struct RoadPath {
  float length_m = 200.0f;
  float bend_m = 0.0f;

  /// Adds the rule that the tightest radius is at least 100 m, so that nothing beside a bend reaches its centre.
  void describe(ParameterList& list);

  /// The point `along` metres down -Z and `offset` metres to the right. Valid beyond both ends.
  glm::vec3 point(float along, float offset = 0.0f) const;
  glm::vec3 direction(float along) const;
  /// The yaw (radians) that turns a thing facing -Z into the direction of travel.
  float yaw(float along) const;
  /// How far right of the path a point lies, measured at right angles to it: exact on a straight path, close on a
  /// gentle bend.
  float offset_of(float x, float z) const;
  /// Points from `from` to `to`, at most `step` metres apart.
  std::vector<glm::vec3> line(float from, float to, float step, float offset, float height) const;
};

}  // namespace litfog::scene
