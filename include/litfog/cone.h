// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "litfog/value_error.h"

namespace litfog {

/// How a light's intensity falls with the angle u from its axis.
enum class ConeProfile {
  /// 1 everywhere: a point light.
  none,
  /// cos^exponent(u) for u < half_angle, else 0 (Steven Hales 2004, "Realtime Pixel Lighting Using Fragment Programs",
  /// section "Lighting Algorithms").
  cosine,
  /// smoothstep(cos outer, cos inner, cos u): the dual cone of Randima Fernando and Mark Kilgard 2003, "The Cg
  /// Tutorial", section 5.5.2.
  smoothstep,
};

/// Angular shape of a light. Angles are radians from the axis (half angles).
struct Cone {
  ConeProfile profile = ConeProfile::none;
  double half_angle = 0;  ///< cosine: H in (0, pi/2], where the light is cut off
  double exponent = 0;    ///< cosine: S >= 0, finite; 0 is a flat beam
  double inner = 0;       ///< smoothstep: [0, outer), full intensity up to here
  double outer = 0;       ///< smoothstep: (inner, pi], no light beyond

  friend bool operator==(const Cone&, const Cone&) = default;

  static Cone cosine(double half_angle, double exponent) {
    return {.profile = ConeProfile::cosine, .half_angle = half_angle, .exponent = exponent};
  }
  static Cone smoothstep(double inner, double outer) {
    return {.profile = ConeProfile::smoothstep, .inner = inner, .outer = outer};
  }
};

/// What is wrong with a cone, or nothing.
std::optional<ValueError> check(const Cone& cone);

// The functions below are for inner loops and do not check their arguments: `cone` is one that check() finds nothing
// wrong with.

/// Half angle beyond which a cone is dark: radians, pi for a point light.
double cutoff_angle(const Cone& cone);

/// Largest errors of cone_at: of a cosine cone in ulp; of a smoothstep cone the absolute error times the width of its
/// edge, cos inner - cos outer, because a narrow edge magnifies the rounding of the cosines.
inline constexpr double kCosineConeMaxUlp = 1;
inline constexpr double kSmoothstepConeMaxErrorTimesWidth = 4e-16;

/// Fraction of the axial intensity that a cone sends into a direction.
///
/// cos_angle  cosine of the angle from the axis, [-1, 1]
/// returns    [0, 1]
/// max error  cosine: kCosineConeMaxUlp, except where cos_angle is within an ulp of the half angle's cosine, whose
///            rounding then decides between the edge's value and 0;
///            smoothstep: kSmoothstepConeMaxErrorTimesWidth / (cos inner - cos outer)               (cone_test.cpp)
double cone_at(const Cone& cone, double cos_angle);

/// Largest errors of angle_at_level and flux_within, relative.
inline constexpr double kAngleAtLevelMaxError = 2e-15;
inline constexpr double kFluxMaxError = 2e-15;

/// Angle up to which a cone keeps a fraction of its axial intensity: acos(level^(1/exponent)) of a cosine cone, the
/// root of Hermite's cubic of a smoothstep cone, or the cut-off angle if the cone is still brighter there.
///
/// level      (0, 1)
/// returns    radians from the axis, [0, pi]; pi for a point light
/// max error  kAngleAtLevelMaxError                                                                 (cone_test.cpp)
double angle_at_level(const Cone& cone, double level);

/// Flux of a cone whose axial intensity is 1, out to an angle: 2 pi times the integral of cone_at(cos u) sin u.
/// Times candela on the axis it is lumens.
///
/// angle      radians from the axis, [0, pi]
/// returns    steradians, [0, 4 pi]
/// max error  kFluxMaxError                                                                         (cone_test.cpp)
double flux_within(const Cone& cone, double angle);

}  // namespace litfog
