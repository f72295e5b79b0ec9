// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <numbers>
#include <optional>
#include <span>

#include "litfog/value_error.h"

namespace litfog {

/// How a light's intensity falls with the angle u from its axis. kConeProfiles has each profile's name and parameters.
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

  constexpr bool is_point_light() const { return profile == ConeProfile::none; }

  static constexpr Cone cosine(double half_angle, double exponent) {
    return {.profile = ConeProfile::cosine, .half_angle = half_angle, .exponent = exponent};
  }
  static constexpr Cone smoothstep(double inner, double outer) {
    return {.profile = ConeProfile::smoothstep, .inner = inner, .outer = outer};
  }
};

/// A parameter of a profile. Files and controls use degrees for radians.
struct ConeParameter {
  const char* field;      ///< "cone.inner"
  const char* file_name;  ///< "inner_deg"
  const char* label;      ///< a control's: "Inner"
  double Cone::*member;
  bool is_angle;
  double least;  ///< smallest value that the rule allows, or its limit
  double most;   ///< largest value that the rule allows, or its limit
  const char* rule;
  const char* rule_in_file;
  std::array<double, 2> control;  ///< a slider's ends
  const char* meaning;

  constexpr const char* name() const { return field + 5; }  ///< the member's: "inner"
};

/// A profile's name and parameters.
struct ConeProfileFacts {
  ConeProfile profile;
  const char* name;  ///< as the enumerator, and in files
  const char* meaning;
  std::span<const ConeParameter> parameters;
  const ConeParameter* cutoff;  ///< the parameter beyond which a cone is dark, if there is one
  Cone first;                   ///< a control's cone when the profile is chosen
};

namespace cone_parameters {
inline constexpr double kPi = std::numbers::pi, kInfinity = std::numeric_limits<double>::infinity();
// clang-format off
inline constexpr std::array<ConeParameter, 2> kCosine{{
    {"cone.half_angle", "half_angle_deg", "Half angle", &Cone::half_angle, true, 0, kPi / 2, "must be in (0, pi/2]",
     "must be in (0, 90]", {1, 90}, "(0, pi/2], where the light is cut off"},
    {"cone.exponent", "exponent", "Exponent", &Cone::exponent, false, 0, kInfinity, "must be finite and >= 0",
     "must be finite and >= 0", {0, 5000}, "finite, >= 0; 0 is a flat beam"}}};
inline constexpr std::array<ConeParameter, 2> kSmoothstep{{
    {"cone.inner", "inner_deg", "Inner", &Cone::inner, true, 0, kPi, "must be in [0, outer)",
     "must be in [0, outer_deg)", {0, 179}, "[0, outer), full intensity up to here"},
    {"cone.outer", "outer_deg", "Outer", &Cone::outer, true, 0, kPi, "must be in (0, pi]",
     "must be in (0, 180]", {1, 180}, "(inner, pi], no light beyond"}}};
// clang-format on
}  // namespace cone_parameters

/// All profiles by number. A new profile needs a row here, a case in each switch of src, and its number and formulas in
/// litfog/shaders/cone_profile.glsl.
inline constexpr std::array<ConeProfileFacts, 3> kConeProfiles{
    {{ConeProfile::none, "none", "1 everywhere: a point light", {}, nullptr, {}},
     {ConeProfile::cosine, "cosine", "cos^exponent(u) up to half_angle", cone_parameters::kCosine,
      &cone_parameters::kCosine[0], Cone::cosine(std::numbers::pi / 6, 4)},
     {ConeProfile::smoothstep, "smoothstep", "smoothstep(cos outer, cos inner, cos u)", cone_parameters::kSmoothstep,
      &cone_parameters::kSmoothstep[1], Cone::smoothstep(std::numbers::pi / 12, std::numbers::pi / 6)}}};
inline constexpr std::size_t kMaxConeParameters = 2;  ///< per profile

constexpr const ConeProfileFacts& facts_of(ConeProfile profile) { return kConeProfiles[std::size_t(profile)]; }

/// What is wrong with a cone, or nothing.
std::optional<ValueError> find_error(const Cone& cone);

// The functions below are for inner loops and do not check their arguments: `cone` must pass find_error().

/// Half angle beyond which a cone is dark: radians, pi for a point light.
double cutoff_angle(const Cone& cone);

/// Fraction of the axial intensity at which a cone is cut off: 0 for a cone that fades out, and for a point light.
double cutoff_level(const Cone& cone);

/// Half angle beyond which a cone has half its axial intensity or less, and within which it has most of its light:
/// radians, pi for a point light. angle_at_level() gives the least such angle.
double dim_angle(const Cone& cone);

/// Largest errors of cone_at: for a cosine cone in ulp; for a smoothstep cone the absolute error times the width of its
/// edge, cos inner - cos outer, because a narrow edge magnifies the rounding of the cosines.
inline constexpr double kCosineConeMaxUlp = 1;
inline constexpr double kSmoothstepConeMaxErrorTimesWidth = 8e-16;

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

/// Angle up to which a cone keeps a fraction of its axial intensity: acos(level^(1/exponent)) for a cosine cone, the
/// root of Hermite's cubic for a smoothstep cone, or the cut-off angle if the cone is still brighter there.
///
/// level      (0, 1)
/// returns    radians from the axis, [0, pi]; pi for a point light
/// max error  kAngleAtLevelMaxError                                                                 (cone_test.cpp)
double angle_at_level(const Cone& cone, double level);

/// Flux of a cone with axial intensity 1, out to an angle: 2 pi times the integral of cone_at(cos u) sin u. Multiplied
/// by candela on the axis it is in lumens.
///
/// angle      radians from the axis, [0, pi]
/// returns    steradians, [0, 4 pi]
/// max error  kFluxMaxError                                                                         (cone_test.cpp)
double flux_within(const Cone& cone, double angle);

}  // namespace litfog
