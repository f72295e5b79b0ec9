// SPDX-License-Identifier: Apache-2.0
#include "scene/cube_face.h"

#include <array>
#include <cmath>

namespace litfog::scene {

glm::dvec3 cube_direction(int face, double u, double v) {
  const std::array<glm::dvec3, 6> directions{
      {{1, -v, -u}, {-1, -v, u}, {u, 1, v}, {u, -1, -v}, {u, -v, 1}, {-u, -v, -1}}};
  return directions[std::size_t(face)];
}

CubePlace cube_place(const glm::dvec3& d) {
  const glm::dvec3 a = glm::abs(d);
  if (a.x >= a.y && a.x >= a.z) return {d.x > 0 ? 0 : 1, (d.x > 0 ? -d.z : d.z) / a.x, -d.y / a.x};
  if (a.y >= a.z) return {d.y > 0 ? 2 : 3, d.x / a.y, (d.y > 0 ? d.z : -d.z) / a.y};
  return {d.z > 0 ? 4 : 5, (d.z > 0 ? d.x : -d.x) / a.z, -d.y / a.z};
}

}  // namespace litfog::scene
