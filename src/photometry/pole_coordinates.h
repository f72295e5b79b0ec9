// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec3.hpp>

#include "litfog/photometry/intensity_distribution.h"

namespace litfog {

/// A direction in coordinates about the line on which all half planes of a type meet.
struct PoleCoordinates {
  double pole;   ///< along that line: the vertical axis of type A, the horizontal one of B, the photometric one of C
  double ahead;  ///< in the half plane of turn 0
  double aside;  ///< in the half plane of turn pi / 2
};

inline PoleCoordinates pole_coordinates(PhotometryType type, const glm::dvec3& direction) {
  switch (type) {
    case PhotometryType::a:
      return {direction.y, -direction.z, direction.x};
    case PhotometryType::b:
      return {direction.x, -direction.z, direction.y};
    case PhotometryType::c:
      break;
  }
  return {-direction.z, direction.x, direction.y};
}

}  // namespace litfog
