// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec3.hpp>

namespace litfog {

/// A position on a cube map in OpenGL's convention (OpenGL 4.6, section 8.13 and table 8.19).
struct CubePosition {
  int face;     ///< 0 to 5: +x -x +y -y +z -z
  double u, v;  ///< [-1, 1] along the face's columns and rows, in the order of glTexImage2D
};

/// The direction towards a position, of length 1 to sqrt(3): its largest component is 1 in magnitude.
glm::dvec3 cube_direction(const CubePosition& position);

/// The position in a direction of any length but 0.
CubePosition cube_position(const glm::dvec3& direction);

}  // namespace litfog
