// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <type_traits>

#include "litfog/attenuation.h"
#include "litfog/fog.h"
#include "litfog/light.h"

namespace litfog {

/// How a solve ended.
enum class SolveStatus {
  ok,             ///< the fields hold the supremum to the stated error
  not_converged,  ///< the step cap was reached: intensity is a lower bound, the value at peak_range
};

/// Fog colour intensity of a light, and the range of the peak.
template <typename Real>
struct BasicFogIntensity {
  Real intensity;   ///< [0, 1]
  Real peak_range;  ///< metres, [0, extent]; 0 where the intensity is 0 everywhere or is a(0+); may be infinity
  Real extent;      ///< metres; 0 for a light below its threshold everywhere, infinity for constant attenuation
  SolveStatus status;
};
using FogIntensity = BasicFogIntensity<double>;
using FogIntensityF = BasicFogIntensity<float>;

/// Largest errors of solve_fog_intensity: intensity in ulp, peak range relative. The float peak range is the double's,
/// rounded.
template <typename Real>
inline constexpr double kIntensityMaxUlp = std::is_same_v<Real, float> ? 1 : 2;
inline constexpr double kPeakRangeMaxError = 1e-8;

/// Fog colour intensity of a light: the supremum over [0, extent] of opacity(r) * attenuation(r).
/// Steven Hales 2004, "Realtime Pixel Lighting Using Fragment Programs", section "Lighting in Fog", samples it. Here it
/// is exact: beyond the knee the derivative has the sign of a power series with one change of sign, so the only peak is
/// at the knee, the stationary point, or the extent.
///
/// attenuation  constant (1), linear (1/m), quadratic (1/m^2): finite, >= 0, not all zero
/// fog.density  1/m, >= 0; 0 is clear air (intensity 0), infinity is total fog (attenuation at 0+)
/// threshold    (0, 1): attenuation at which the light ends
/// max error    intensity kIntensityMaxUlp, extent kExtentMaxUlp, peak_range kPeakRangeMaxError  (solve_test.cpp)
/// throws       std::invalid_argument naming field, value and rule
FogIntensity solve_fog_intensity(const Attenuation& attenuation, const Fog& fog, double threshold = kDefaultThreshold);
FogIntensityF solve_fog_intensity(const AttenuationF& attenuation, const FogF& fog,
                                  float threshold = float(kDefaultThreshold));

/// Fog colour intensity of a light, in fog scaled by its density scale.
///
/// throws  std::invalid_argument naming field, value and rule
FogIntensity solve_fog_intensity(const Light& light, const Fog& fog);

/// Largest absolute error of sample_fog_intensity with 64 samples, over the lights and fogs named below.
inline constexpr double kSampled64MaxError = 0.024;

/// Fog colour intensity as published: the largest of N samples at r = extent * i / N, i = 1..N (Hales 2004, "Lighting
/// in Fog"). Kept as a baseline for speed and error. Except for rounding it never exceeds the intensity. With 64
/// samples it is up to kSampled64MaxError too low for the OGRE wiki's table of lights at visibilities of at least 10 m
/// (solve_test.cpp). The error is larger in thicker fog or at lower thresholds.
///
/// samples  N >= 1
/// throws   std::invalid_argument naming field, value and rule
FogIntensity sample_fog_intensity(const Attenuation& attenuation, const Fog& fog, double threshold, int samples);

}  // namespace litfog
