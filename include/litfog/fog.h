// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "litfog/value_error.h"

namespace litfog {

/// How the fog factor (transmittance) f falls with range. The shaders and C use the same numbers.
enum class FogMode {
  exp = 0,   ///< f(r) = e^(-d r)
  exp2 = 1,  ///< f(r) = e^(-(d r)^2)
};

/// "exp" or "exp2".
const char* name_of(FogMode mode);

/// Contrast thresholds c that give a visibility its meaning: the range at which f has fallen to c.
inline constexpr double kContrastMor = 0.05;          ///< meteorological optical range (WMO, ICAO Annex 3); the default
inline constexpr double kContrastKoschmieder = 0.02;  ///< Koschmieder 1924
inline constexpr double kContrastFlightgear = 0.01;   ///< FlightGear's fog density

/// Largest error of BasicFog::from_visibility in ulp.
inline constexpr double kDensityMaxUlp = 3;

/// Homogeneous fog.
template <typename Real>
struct BasicFog {
  FogMode mode = FogMode::exp;
  Real density = 0;  ///< d, 1/m, >= 0. 0 is clear air, infinity total fog.

  friend bool operator==(const BasicFog&, const BasicFog&) = default;

  /// The fog of a visibility: exp d = -ln(c) / V, exp2 d = sqrt(-ln(c)) / V.
  ///
  /// metres    V >= 0; infinity is no fog (d = 0), 0 is total fog (d = infinity)
  /// contrast  c in (0, 1)
  /// max error kDensityMaxUlp                                                   (fog_test.cpp)
  /// throws    std::invalid_argument naming field, value and rule
  static BasicFog from_visibility(FogMode mode, Real metres, Real contrast = Real(kContrastMor));
};
using Fog = BasicFog<double>;
using FogF = BasicFog<float>;

/// What is wrong with a fog, or nothing.
std::optional<ValueError> find_error(const Fog& fog);

/// Largest error of visibility in ulp.
inline constexpr double kVisibilityMaxUlp = 3;

/// The visibility of a fog, the inverse of Fog::from_visibility.
///
/// contrast   c in (0, 1)
/// returns    metres; infinity in clear air, 0 in total fog
/// max error  kVisibilityMaxUlp                                                 (fog_test.cpp)
/// throws     std::invalid_argument naming field, value and rule
double visibility(const Fog& fog, double contrast = kContrastMor);

/// Fog for a class of lights: the density times the class's scale (1/2.5 for FlightGear's runway lights).
///
/// density_scale  >= 0, finite; clear air stays clear and total fog stays total unless the scale is 0
/// throws         std::invalid_argument naming field, value and rule
Fog scaled(const Fog& fog, double density_scale);

/// Largest absolute error of fog_factor_at. A relative error of the optical depth x, which has up to 3 roundings,
/// changes the factor by x e^-x < 0.37 times that error, and the exponential adds less than an ulp.
inline constexpr double kFogFactorMaxError = 2.5e-16;

/// Fog factor f(r), the fraction of light that passes through fog over a range. For inner loops: checks no argument.
///
/// fog        must pass find_error()
/// range      metres, >= 0
/// returns    [0, 1]
/// max error  kFogFactorMaxError                                                (fog_test.cpp)
double fog_factor_at(const Fog& fog, double range);

/// Largest error of opacity_at in ulp.
inline constexpr double kOpacityMaxUlp = 4;

/// Opacity 1 - f(r), computed without cancellation. For inner loops: checks no argument.
///
/// fog        must pass find_error()
/// range      metres, >= 0
/// returns    [0, 1]
/// max error  kOpacityMaxUlp                                                    (fog_test.cpp)
double opacity_at(const Fog& fog, double range);

}  // namespace litfog
