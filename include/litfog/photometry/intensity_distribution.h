// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "litfog/value_error.h"

namespace litfog {

/// How a goniophotometer turned the luminaire, which gives the two angles their meaning (IES LM-63-2002, section 3;
/// LM-75-01).
///
/// Directions are in the luminaire frame, the same for all three types: the photometric axis is -z, +y is up (types A
/// and B), and +x is to the right when looking along the axis.
///     A  (cos V sin H, sin V, -cos V cos H)       half planes round the vertical axis, V is the elevation in one
///     B  (sin H, cos H sin V, -cos H cos V)       half planes round the horizontal axis, H is the elevation in one
///     C  (sin V cos H, sin V sin H, -cos V)       half planes round the photometric axis, V = 0 at the nadir
/// Seen from above, H runs clockwise in types A and B. In type C (EULUMDAT: C and gamma) it runs counterclockwise, seen
/// from above the luminaire, which is behind the light.
enum class PhotometryType { a, b, c };

/// The axis of every photometric file: the nadir in type C, H = V = 0 in types A and B.
inline constexpr glm::dvec3 kPhotometricAxis{0, 0, -1};

/// Largest intensity of a distribution, candela, at which squares and sums stay finite.
inline constexpr double kMaxIntensity = 1e30;

/// Luminous intensity by direction, as measured. It is bilinear between the measured angles and 0 outside them. On the
/// axis of type C, where all planes meet, it is their mean. Symmetry is applied at look-up, so only the measured part
/// is stored.
struct IntensityDistribution {
  PhotometryType type = PhotometryType::c;

  /// Radians, strictly increasing. Type C: one angle (rotationally symmetric), or a span of pi / 2 (mirrored at both
  /// ends), pi (mirrored at its first angle) or 2 pi. Types A and B: at least two within [-pi, pi] (A) or
  /// [-pi / 2, pi / 2] (B); mirrored at 0 if they start there.
  std::vector<double> horizontal;
  /// Radians, strictly increasing, at least two. Type C: within [0, pi]. Types A and B: within [-pi / 2, pi / 2] (A) or
  /// [-pi, pi] (B); mirrored at 0 if they start there.
  std::vector<double> vertical;
  /// Candela, [0, kMaxIntensity], not all 0; the index of horizontal[h] and vertical[v] is h * vertical.size() + v.
  std::vector<double> intensity;
};

/// What is wrong with a distribution, or nothing. Every call below except intensity_at() throws it as
/// std::invalid_argument.
std::optional<ValueError> find_error(const IntensityDistribution& distribution);

/// Luminous intensity towards a direction.
///
/// distribution  must pass find_error(); not checked here
/// direction     luminaire frame, of any length but 0
/// returns       candela
double intensity_at(const IntensityDistribution& distribution, const glm::dvec3& direction);

/// Luminous flux in lumens: the interpolated intensity, integrated over the sphere in closed form.
///
/// max error     1e-12 relative, or 1e-15 of the peak in all directions       (intensity_distribution_test.cpp)
double luminous_flux(const IntensityDistribution& distribution);

/// The largest intensity, always at measured angles.
struct IntensityPeak {
  double intensity;      ///< candela, > 0
  glm::dvec3 direction;  ///< unit, luminaire frame; among equal peaks one closest to the photometric axis
};
IntensityPeak find_peak(const IntensityDistribution& distribution);

/// The two angles of a direction, radians: horizontal in (-pi, pi], in [-pi / 2, pi / 2] for type B.
struct PhotometricAngles {
  double horizontal;
  double vertical;
};

/// direction  luminaire frame, of any length but 0
PhotometricAngles angles_of(PhotometryType type, const glm::dvec3& direction);

/// The direction of a type's two angles, in radians: unit, luminaire frame.
glm::dvec3 direction_of(PhotometryType type, double horizontal, double vertical);

/// The rotation from a light's frame, whose -z is the light's axis, to the luminaire frame: the identity for the
/// photometric axis. The light's +y is as near to the luminaire's +y as the axis allows, or to -z if the axis is +y or
/// -y.
///
/// axis      luminaire frame, of any length but 0
/// throws    std::invalid_argument naming field, value and rule
glm::dmat3 luminaire_from_light(const glm::dvec3& axis);

}  // namespace litfog
