// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>

#include "litfog/photometry/intensity_distribution.h"

namespace litfog {

/// Whether any intensity of a vertical angle, by its index, is above 0.
bool is_row_lit(const IntensityDistribution& distribution, std::size_t vertical);

/// A direction by the line on which all half planes of a type meet.
struct PoleCoordinates {
  double pole;   ///< along that line: the vertical axis of type A, the horizontal one of B, the photometric one of C
  double ahead;  ///< in the half plane of turn 0
  double aside;  ///< in that of turn pi / 2
};
PoleCoordinates pole_coordinates(PhotometryType type, const glm::dvec3& direction);

/// The directions outside a distribution's lit angles, which most are of a narrow beam. A unit direction lies there if
///     pole < least_pole, or pole > most_pole,
///     or its turn is below or above the lit ones: low_ahead ahead - low_aside aside > 0 or the like of high; both if
///     the lit turn is more than a half.
/// No inverse trigonometric function is needed for that.
struct Darkness {
  explicit Darkness(const IntensityDistribution& distribution);

  double least_pole, most_pole;
  double low_ahead = 0, low_aside = 0;  // 0, as of type C: no turn is below
  double high_ahead = 0, high_aside = 0;
  bool is_wide = false;
};

}  // namespace litfog
