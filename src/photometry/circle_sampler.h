// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <vector>

#include "litfog/photometry/intensity_distribution.h"
#include "photometry/angle_index.h"
#include "photometry/darkness.h"
#include "photometry/pole_coordinates.h"

namespace litfog {

inline constexpr int kEquatorSteps = 360;  // steps of the largest circle about an axis; others by circumference
inline constexpr int kMinSteps = 72;       // steps of any circle

/// The intensities on a circle about an axis.
struct Circle {
  double mean = 0;               ///< candela
  double largest_deviation = 0;  ///< largest difference from the mean
  double rms_deviation = 0;
};

/// A distribution prepared for looking up many intensities.
struct CircleTable {
  explicit CircleTable(const IntensityDistribution& distribution);

  bool is_c;
  AngleIndex turn;        // angles about the pole; type C: from the first plane
  AngleIndex rise;        // angles from the pole (type C) or from the equator (types A and B)
  double first_turn = 0;  // type C only, in [-pi, pi]
  int multiplicity = 0;   // type C only: number of parts in a turn
  bool is_turn_mirrored = false, is_rise_mirrored = false;
  double nadir, zenith;  // intensities on the pole of type C, where all planes meet
  double unit;  // candela: a power of 2 near the largest intensity, so that squares neither over- nor underflow
  const double* intensity;
  Darkness darkness;
};

/// Samples circles about any axis in even steps of the turn, which starts at the light's +x (luminaire_from_light):
/// steps of a degree on the largest circle, and at least 72 on any.
class CircleSampler {
 public:
  /// distribution  must outlive the sampler
  CircleSampler(const IntensityDistribution& distribution, const glm::dvec3& axis);

  /// angle  from the axis, radians in [0, pi]
  Circle at(double angle) const;

 private:
  CircleTable table_;
  PoleCoordinates forward_;
  std::array<std::vector<PoleCoordinates>, kEquatorSteps / kMinSteps> rims_;  // by every degree, every other, ...
};

}  // namespace litfog
