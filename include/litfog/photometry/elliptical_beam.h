// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "litfog/photometry/intensity_distribution.h"
#include "litfog/value_error.h"

namespace litfog {

/// A line of equal intensity about an axis, an ellipse in angles as isocandela diagrams draw it (ICAO Annex 14,
/// appendix 2): the directions at an angle u from the axis, turned about it by t from the light's +x, with
/// (u cos t / horizontal)^2 + (u sin t / vertical)^2 = 1.
struct IsocandelaEllipse {
  double intensity = 0;   ///< candela, [0, 1e30]
  double horizontal = 0;  ///< half axis, radians, [1e-100, pi]
  double vertical = 0;    ///< half axis, radians, [1e-100, pi]
};

/// What is wrong with ellipses, or nothing. There must be at least one, and not all may be dark. From one to the next,
/// both half axes must grow, and the intensity must not.
std::optional<ValueError> find_error(const std::vector<IsocandelaEllipse>& ellipses);

/// Largest errors of elliptical_beam() for ellipses with axis ratios up to 4: flux relative; that of beams without
/// steps, whose last line has at most a tenth of the peak and which grow by half from line to line; intensity, where it
/// is continuous, as a fraction of the peak.
inline constexpr double kEllipticalFluxMaxError = 3e-3;
inline constexpr double kSmoothEllipticalFluxMaxError = 2e-4;
inline constexpr double kEllipticalBeamMaxError = 0.05;

/// A beam from its isocandela lines, as a table of type C about the photometric axis. Up to each line, from that within
/// it, the angles are 1 / 512 of the line's larger half axis apart. Within the first line the intensity is the line's,
/// between two lines it is linear in the angle from the axis, and beyond the last it is 0.
///
/// max error   kEllipticalFluxMaxError and the two below it                                  (elliptical_beam_test.cpp)
/// throws      std::invalid_argument naming field, value and rule
IntensityDistribution elliptical_beam(const std::vector<IsocandelaEllipse>& ellipses);

/// Largest error of equal_circle(), radians, for ellipses with axis ratios up to 20.
inline constexpr double kEqualCircleMaxError = 1e-12;

/// Half angle of the circle with the solid angle of an ellipse. A beam whose isocandela lines are replaced by such
/// circles keeps its flux. For small ellipses it is about sqrt(horizontal * vertical).
///
/// horizontal, vertical  half axes, radians, (0, pi]
/// returns               radians
/// max error             kEqualCircleMaxError                                                (elliptical_beam_test.cpp)
double equal_circle(double horizontal, double vertical);

}  // namespace litfog
