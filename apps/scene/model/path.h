// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace litfog::scene {

/// The line that a road and all that stands along it follow: from the origin towards -Z, a parabola that has left the
/// -Z axis by `bend_m` (to +X, the right) at its end.
struct Path {
  float length_m = 200.0f;
  float bend_m = 0.0f;

  /// The point `along` metres down -Z and `offset` metres to the right. Valid beyond both ends.
  glm::vec3 point(float along, float offset = 0.0f) const {
    const glm::vec3 d = direction(along);
    const float t = along / length_m;
    return glm::vec3(bend_m * t * std::abs(t), 0.0f, -along) + offset * glm::vec3(-d.z, 0.0f, d.x);
  }
  glm::vec3 direction(float along) const {
    return glm::normalize(glm::vec3(2.0f * bend_m * std::abs(along) / (length_m * length_m), 0.0f, -1.0f));
  }
  /// The yaw (radians) that turns a thing facing -Z into the direction of travel.
  float yaw(float along) const {
    const glm::vec3 d = direction(along);
    return std::atan2(-d.x, -d.z);
  }
  /// How far right of the path a point lies, measured square to -Z; good where the bend is gentle.
  float offset_of(float x, float z) const {
    const glm::vec3 d = direction(-z);
    return (x - point(-z).x) * -d.z;
  }
  /// Points from `from` to `to`, at most `step` metres apart.
  std::vector<glm::vec3> line(float from, float to, float step, float offset, float height) const {
    const int pieces = std::max(1, int(std::ceil((to - from) / step)));
    std::vector<glm::vec3> points;
    for (int i = 0; i <= pieces; ++i) {
      const float along = from + (to - from) * float(i) / float(pieces);
      points.push_back(point(along, offset) + glm::vec3(0.0f, height, 0.0f));
    }
    return points;
  }
};

}  // namespace litfog::scene
