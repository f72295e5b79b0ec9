// SPDX-License-Identifier: Apache-2.0
#include "scene/light_frame.h"

#include <algorithm>
#include <cmath>

namespace litfog::scene {
namespace {

/// A matrix by its rows.
glm::dmat3 rows(const glm::dvec3& x, const glm::dvec3& y, const glm::dvec3& z) {
  return glm::transpose(glm::dmat3(x, y, z));
}

// Rotations into coordinates (x ahead, y left, z up) that are turned to the right, up, and to the right about x.
glm::dmat3 turned_right(double a) {
  return rows({std::cos(a), -std::sin(a), 0}, {std::sin(a), std::cos(a), 0}, {0, 0, 1});
}
glm::dmat3 turned_up(double a) {
  return rows({std::cos(a), 0, std::sin(a)}, {0, 1, 0}, {-std::sin(a), 0, std::cos(a)});
}
glm::dmat3 rolled_right(double a) {
  return rows({1, 0, 0}, {0, std::cos(a), std::sin(a)}, {0, -std::sin(a), std::cos(a)});
}

}  // namespace

Bearing bearing_of(const glm::dvec3& direction) {
  return {std::atan2(direction.x, -direction.z), std::asin(std::clamp(direction.y, -1.0, 1.0))};
}

glm::dmat3 viewpoint_from_world(const Attitude& viewpoint) {
  const glm::dmat3 level = rows({0, 0, -1}, {-1, 0, 0}, {0, 1, 0});
  return rolled_right(viewpoint.roll) * turned_up(viewpoint.pitch) * turned_right(viewpoint.heading) * level;
}

glm::dmat3 light_from_world(const Bearing& light, const Attitude& viewpoint) {
  return turned_up(light.elevation) * turned_right(light.azimuth) * viewpoint_from_world(viewpoint);
}

glm::dmat3 basis_from_world(const glm::dvec3& direction) {
  const bool is_upright = std::abs(direction.y) > 0.999;  // then any up direction will do
  const glm::dvec3 right =
      glm::normalize(glm::cross(direction, is_upright ? glm::dvec3(0, 0, -1) : glm::dvec3(0, 1, 0)));
  return rows(right, glm::cross(right, direction), -direction);
}

glm::dmat3 cookie_from_world(const glm::dvec3& direction, double roll) {
  const double c = std::cos(roll), s = std::sin(roll);
  return glm::dmat3(c, s, 0, -s, c, 0, 0, 0, 1) * basis_from_world(direction);
}

}  // namespace litfog::scene
