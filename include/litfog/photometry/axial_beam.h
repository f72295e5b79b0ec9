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
  double mean;       ///< candela, over the turn
  double deviation;  ///< candela: largest magnitude of the difference from the mean on the circle
};

/// A distribution as a beam about an axis, by circles about that axis. Each circle is sampled once, when first needed.
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

  /// Intensity against the angle from the axis, as the mean over the turn: what a cone about the axis is fitted to. If
  /// the axis is the photometric one of type C or its opposite, the angles are the measured ones and the mean is that
  /// of linear interpolation between the planes; otherwise the angles are every quarter degree from 0 to pi, in a finer
  /// grid the first hundred in its smallest step (at least 0.01 degrees), and the mean is over 72 to 360 directions.
  /// Angles that were not measured are dark: from the first and last measured ones, the profile goes on in their steps
  /// to 0 and pi with intensity 0, which begins 0.01 degrees beyond a lit one.
  ///
  /// returns   increasing angles from 0 to pi
  std::vector<AxialSample> profile();

  /// How far the beam is from rotational symmetry: sqrt(integral of (I - mean)^2 / integral of I^2) over the sphere,
  /// with the mean taken over the turn. The mean is the closest symmetric beam, so no cone profile can have a smaller
  /// relative rms error than this. 0 for a symmetric beam, at most 1.
  ///
  /// limit      >= 0; the search ends once the asymmetry is known to be above it, and the result is then a lower bound
  /// max error  0.001 for beams that change little within a degree: on every second circle of the profile. About the
  ///            photometric axis of type C and its opposite 1e-9, for the intensity as interpolated between angles at
  ///            most 60 degrees apart                                                           (axial_beam_test.cpp)
  double asymmetry(double limit = std::numeric_limits<double>::infinity());

 private:
  class Circles;

  const IntensityDistribution* distribution_;
  glm::dvec3 axis_;
  std::unique_ptr<Circles> circles_;  // null about the grid's own axis
  std::optional<double> asymmetry_;   // once a search has gone to its end
};

/// Intensity against the angle along one half plane about an axis, as data sheets show it: the angles are those of the
/// beam's profile, and the deviation is 0.
///
/// turn      radians: 0 is towards the light's +x (the photometric axis of type C: the plane C0), pi / 2 towards its +y
///           (C90)
/// throws    std::invalid_argument naming field, value and rule
std::vector<AxialSample> plane_profile(const IntensityDistribution& distribution, double turn,
                                       const glm::dvec3& axis = kPhotometricAxis);

/// The first angle beyond the peak at which a profile, linear between its samples, falls to a fraction of the peak:
/// half of a data sheet's beam angle at 0.5, half of its field angle at 0.1.
///
/// profile   at least one sample, means finite and >= 0
/// fraction  (0, 1]
/// returns   radians; the last sample's angle if the profile ends above the fraction
/// throws    std::invalid_argument naming field, value and rule
double half_angle(const std::vector<AxialSample>& profile, double fraction);

}  // namespace litfog
