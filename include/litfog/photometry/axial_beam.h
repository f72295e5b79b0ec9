// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec3.hpp>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "litfog/photometry/intensity_distribution.h"

namespace litfog {

/// Intensity on a circle about an axis.
struct AxialSample {
  double angle;      ///< from the axis, radians in [0, pi]
  double mean;       ///< candela, over the circle
  double deviation;  ///< candela: largest difference from the mean, in magnitude
};

/// A distribution as a beam about an axis, sampled on circles. Each circle is sampled once, when first needed.
class AxialBeam {
 public:
  /// distribution  must outlive the beam and not change
  /// axis          luminaire frame, of any length but 0
  /// throws        std::invalid_argument naming field, value and rule
  AxialBeam(const IntensityDistribution& distribution, const glm::dvec3& axis);
  AxialBeam(AxialBeam&& other) noexcept;
  AxialBeam& operator=(AxialBeam&& other) noexcept;
  ~AxialBeam();

  const glm::dvec3& axis() const { return axis_; }

  /// Mean intensity of each circle, by angle from the axis: the data for fitting a cone. About the photometric axis of
  /// type C or its opposite, the angles are the measured ones, and the mean interpolates linearly between the planes.
  /// Otherwise the angles are every quarter degree from 0 to pi; a finer grid has its first hundred angles in the
  /// file's smallest step (at least 0.01 degrees). The mean is then over 72 to 360 directions. Angles that were not
  /// measured are dark: beyond the first and last measured ones, the profile continues in their steps to 0 and pi with
  /// intensity 0, which begins 0.01 degrees beyond a lit angle.
  ///
  /// returns   increasing angles from 0 to pi
  std::vector<AxialSample> profile();

  /// How far the beam is from rotational symmetry: sqrt(integral of (I - mean)^2 / integral of I^2) over the sphere,
  /// with the mean of each circle. The mean is the closest symmetric beam, so no cone profile can have a smaller
  /// relative rms error than this. 0 for a symmetric beam, at most 1.
  ///
  /// limit      >= 0; the search ends once the asymmetry is known to exceed it, and the result is then a lower bound
  /// max error  0.001 for beams that change little within a degree: on every second circle of the profile. About the
  ///            photometric axis of type C and its opposite 1e-9, for the intensity as interpolated between angles at
  ///            most 60 degrees apart                                                           (axial_beam_test.cpp)
  double asymmetry(double limit = std::numeric_limits<double>::infinity());

 private:
  class Circles;

  const IntensityDistribution* distribution_;
  glm::dvec3 axis_;
  std::unique_ptr<Circles> circles_;  // null about the grid's own axis
  std::optional<double> asymmetry_;   // set once a search was complete
};

/// Intensity by angle in one half plane from an axis, as data sheets show it. The angles are those of the beam's
/// profile; the deviation is 0.
///
/// turn      radians: 0 is towards the light's +x (for the photometric axis of type C, plane C0), pi / 2 towards +y
///           (C90)
/// throws    std::invalid_argument naming field, value and rule
std::vector<AxialSample> plane_profile(const IntensityDistribution& distribution, double turn,
                                       const glm::dvec3& axis = kPhotometricAxis);

/// The first angle beyond the peak at which a linearly interpolated profile falls to a fraction of the peak: half of a
/// data sheet's beam angle at 0.5, half of its field angle at 0.1.
///
/// profile   at least one sample, means finite and >= 0
/// fraction  (0, 1]
/// returns   radians; the last sample's angle if the profile ends above the fraction
/// throws    std::invalid_argument naming field, value and rule
double half_angle(const std::vector<AxialSample>& profile, double fraction);

}  // namespace litfog
