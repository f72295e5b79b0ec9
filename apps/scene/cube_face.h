// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

namespace litfog::scene {

/// The direction in which a cube map is looked up at a place of a face (OpenGL 3.3, 3.8.6).
///
/// face  0 to 5: +x -x +y -y +z -z
/// u, v  [-1, 1] along the columns and rows of glTexImage2D
glm::dvec3 cube_direction(int face, double u, double v);

/// The other way round.
struct CubePlace {
  int face;
  double u, v;
};
CubePlace cube_place(const glm::dvec3& direction);

}  // namespace litfog::scene
