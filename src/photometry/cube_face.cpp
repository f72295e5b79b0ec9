// SPDX-License-Identifier: Apache-2.0
#include "litfog/photometry/cube_face.h"

#include <array>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace litfog {
namespace {

/// A face as three axes: its direction, and where u and v grow (OpenGL 4.6, table 8.19).
struct CubeFace {
  glm::dvec3 outwards, u, v;
};

constexpr std::array<CubeFace, 6> kFaces{{
    {{1, 0, 0}, {0, 0, -1}, {0, -1, 0}},
    {{-1, 0, 0}, {0, 0, 1}, {0, -1, 0}},
    {{0, 1, 0}, {1, 0, 0}, {0, 0, 1}},
    {{0, -1, 0}, {1, 0, 0}, {0, 0, -1}},
    {{0, 0, 1}, {1, 0, 0}, {0, -1, 0}},
    {{0, 0, -1}, {-1, 0, 0}, {0, -1, 0}},
}};

}  // namespace

glm::dvec3 cube_direction(const CubePosition& position) {
  const CubeFace& face = kFaces[std::size_t(position.face)];
  return face.outwards + face.u * position.u + face.v * position.v;
}

CubePosition cube_position(const glm::dvec3& direction) {
  const glm::dvec3 size = glm::abs(direction);
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const int number = 2 * axis + (direction[axis] > 0 ? 0 : 1);
  const CubeFace& face = kFaces[std::size_t(number)];
  return {number, glm::dot(direction, face.u) / size[axis], glm::dot(direction, face.v) / size[axis]};
}

}  // namespace litfog
