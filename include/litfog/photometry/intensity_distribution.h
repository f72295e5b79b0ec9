// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <optional>
#include <vector>

#include "litfog/value_error.h"

namespace litfog {

/// How a goniophotometer turned the luminaire, and so what its two angles mean (IES LM-63-2002, section 3; LM-75-01).
///
/// Directions are of the luminaire frame, the same for all three: the photometric axis is -z, +y is up (types A and B),
/// and +x is to the right of one who looks along the axis.
///     A  (cos V sin H, sin V, -cos V cos H)       half planes round the vertical axis, V is the elevation in one
///     B  (sin H, cos H sin V, -cos H cos V)       half planes round the horizontal axis, H is the elevation in one
///     C  (sin V cos H, sin V sin H, -cos V)       half planes round the photometric axis, V = 0 at the nadir
/// So H runs clockwise from above in types A and B, and in type C (EULUMDAT: C and gamma) counterclockwise from above
/// the luminaire, which is behind the light.
enum class PhotometryType { a, b, c };

/// The axis of every photometric file: the nadir in type C, H = V = 0 in types A and B.
inline constexpr glm::dvec3 kPhotometricAxis{0, 0, -1};

/// Candela: of a distribution's intensities, whose squares and sums so stay finite.
inline constexpr double kMaxIntensity = 1e30;

/// Luminous intensity by direction, as measured. It is bilinear between the measured angles and 0 outside them. On the
/// axis of type C, where all planes meet, it is their mean over the turn. Symmetry is applied at look-up, so that only
/// the measured part is stored.
struct IntensityDistribution {
  PhotometryType type = PhotometryType::c;

  /// Radians, strictly increasing. Type C: one angle (rotationally symmetric), or a span of pi / 2 (mirrored at both
  /// ends), pi (mirrored at its first angle) or 2 pi. Types A and B: at least two within [-pi, pi] (A) or
  /// [-pi / 2, pi / 2] (B); mirrored at 0 if they start there.
  std::vector<double> horizontal;
  /// Radians, strictly increasing, at least two. Type C: within [0, pi]. Types A and B: within [-pi / 2, pi / 2] (A) or
  /// [-pi, pi] (B); mirrored at 0 if they start there.
  std::vector<double> vertical;
  /// Candela, [0, kMaxIntensity], not all 0; that of horizontal[h] and vertical[v] is at h * vertical.size() + v.
  std::vector<double> intensity;
};

/// What is wrong with a distribution, or nothing. Every call below except intensity_at throws std::invalid_argument if
/// something is.
std::optional<ValueError> check(const IntensityDistribution& distribution);

/// Luminous intensity towards a direction.
///
/// distribution  one that check() finds nothing wrong with; not checked here
/// direction     luminaire frame, of any length but 0
/// returns       candela
double intensity_at(const IntensityDistribution& distribution, const glm::dvec3& direction);

/// Luminous flux in lumens: the intensity as interpolated, integrated over the sphere in closed form.
///
/// max error     1e-12 relative                                               (intensity_distribution_test.cpp)
double luminous_flux(const IntensityDistribution& distribution);

/// The largest intensity, always at measured angles.
struct IntensityPeak {
  double intensity;      ///< candela, > 0
  glm::dvec3 direction;  ///< unit, luminaire frame; of several equal peaks one closest to the photometric axis
};
IntensityPeak find_peak(const IntensityDistribution& distribution);

/// A type's two angles of a direction, radians: horizontal in (-pi, pi], of type B in [-pi / 2, pi / 2].
struct PhotometricAngles {
  double horizontal;
  double vertical;
};

/// direction  luminaire frame, of any length but 0
PhotometricAngles angles_of(PhotometryType type, const glm::dvec3& direction);

/// The direction of a type's two angles, in radians: unit, luminaire frame.
glm::dvec3 direction_of(PhotometryType type, double horizontal, double vertical);

/// The rotation from the frame of a light with an axis, which is its -z, to the luminaire frame: the identity for the
/// photometric axis. The light's +y is as near to the luminaire's as the axis lets it be, or to -z where that is +y or
/// -y.
///
/// axis      luminaire frame, of any length but 0
/// throws    std::invalid_argument naming field, value and rule
glm::dmat3 luminaire_from_light(const glm::dvec3& axis);

/// Intensity on a circle about an axis.
struct AxialSample {
  double angle;      ///< from the axis, radians in [0, pi]
  double mean;       ///< candela, over the turn
  double deviation;  ///< candela, the largest from the mean on the circle, in magnitude
};

/// Intensity against the angle from an axis, as the mean over the turn: what a cone about the axis is fitted to. If the
/// axis is the photometric one of type C or its opposite, the angles are the measured ones and the mean is that of what
/// is linear between the planes; else the angles are every quarter degree from 0 to pi, in a finer grid the first
/// hundred in its smallest step (at least 0.01 degrees), and the mean is over 72 to 360 directions. Angles that were
/// not measured are dark: from the first and last measured ones, the profile goes on in their steps to 0 and pi with
/// intensity 0, which begins 0.01 degrees beyond a lit one.
///
/// axis      luminaire frame, of any length but 0
/// returns   increasing angles from 0 to pi
std::vector<AxialSample> axial_profile(const IntensityDistribution& distribution, const glm::dvec3& axis);

/// The same along one half plane about an axis, as data sheets show it: the deviation is 0.
///
/// turn      radians: 0 is towards the light's +x (the photometric axis of type C: the plane C0), pi / 2 towards its +y
///           (C90)
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

/// How far a beam is from rotational symmetry about an axis: sqrt(integral of (I - mean)^2 / integral of I^2) over the
/// sphere, with the mean taken over the turn. The mean is the closest symmetric beam, so no cone profile can have a
/// smaller relative rms error than this. 0 for a symmetric beam, at most 1.
///
/// axis       luminaire frame, of any length but 0
/// limit      the search ends where the asymmetry is above it: the result is then only known to be so, too
/// max error  0.001 for beams that change little within a degree: sampled at about every second of the angles that
///            axial_profile() has about an axis other than the grid's, and in the turn every degree of the largest
///            circle, but exact in the turn about the photometric axis of type C
///                                                                             (intensity_distribution_test.cpp)
double asymmetry(const IntensityDistribution& distribution, const glm::dvec3& axis,
                 double limit = std::numeric_limits<double>::infinity());

}  // namespace litfog
