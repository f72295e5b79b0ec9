// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "litfog/cone.h"
#include "litfog/fit/cone_fit.h"
#include "model/versine.h"

// Internal.

namespace litfog {

/// The levels of a beam angle and a field angle.
inline constexpr double kBeamLevel = 0.5;
inline constexpr double kFieldLevel = 0.1;

/// A sample as the fits see it.
struct ConePoint {
  double angle;
  double cosine;
  double versine;   ///< 1 - cosine, to all digits
  double fraction;  ///< of the largest intensity
  double weight;

  ConePoint(double angle_given, double fraction_given, double weight_given)
      : angle(angle_given),
        cosine(std::cos(angle_given)),
        versine(litfog::versine(angle_given)),
        fraction(fraction_given),
        weight(weight_given) {}

  double loss(double cone) const { return weight * (cone - fraction) * (cone - fraction); }
  /// The least loss for cones between two values.
  double loss(double least, double most) const { return loss(std::clamp(fraction, least, most)); }
};

/// A target's samples and stated angles, by increasing angle.
std::vector<ConePoint> points_of(const ConeTarget& target);

/// The figures of a cone against its target.
///
/// points  points_of(target)
ConeProfileFit assess(const Cone& cone, const std::vector<ConePoint>& points, const ConeTarget& target);

}  // namespace litfog
