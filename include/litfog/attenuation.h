// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <type_traits>

#include "litfog/value_error.h"

namespace litfog {

/// Range attenuation a(r) = min(1, 1 / (constant + linear r + quadratic r^2)) of a point or spot light, r in metres.
/// (Steven Hales 2004, "Realtime Pixel Lighting Using Fragment Programs", section "Lighting Algorithms"; the clamp is
/// from his texel formula.)
template <typename Real>
struct BasicAttenuation {
  Real constant = 1;   ///< C, dimensionless, finite, >= 0. Below 1 the light is clamped to 1 up to its knee.
  Real linear = 0;     ///< L, 1/m, finite, >= 0.
  Real quadratic = 0;  ///< Q, 1/m^2, finite, >= 0. Not all three may be 0.

  friend bool operator==(const BasicAttenuation&, const BasicAttenuation&) = default;
};
using Attenuation = BasicAttenuation<double>;
using AttenuationF = BasicAttenuation<float>;

/// Default attenuation at which a light ends (Hales 2004: "a small attenuation value, e.g. 0.05").
inline constexpr double kDefaultThreshold = 0.05;

/// What is wrong with an attenuation (or threshold), or nothing.
std::optional<ValueError> find_error(const Attenuation& attenuation);
std::optional<ValueError> find_threshold_error(double threshold);

/// Largest error of attenuation_at in ulp: five roundings.
inline constexpr double kAttenuationMaxUlp = 5;

/// a(r), a light's brightness at a range as a fraction of its near brightness. For inner loops: checks no argument.
///
/// attenuation  must pass find_error()
/// range        metres, >= 0; infinity gives the limit
/// returns      [0, 1]
/// max error    kAttenuationMaxUlp if the coefficients and the range are 0 or within 1e-100..1e100; otherwise the
///              denominator may overflow, which gives 0                                      (attenuation_test.cpp)
double attenuation_at(const Attenuation& attenuation, double range);

/// Largest errors of compute_extent and compute_knee in ulp.
template <typename Real>
inline constexpr double kExtentMaxUlp = std::is_same_v<Real, float> ? 1 : 2;
inline constexpr double kKneeMaxUlp = 2;

/// Extent: the range at which the attenuation falls to the threshold, the positive root E of
/// Q r^2 + L r + (C - 1/t) = 0 (Hales 2004, "Embedding Range Attenuation in a Texture Map").
///
/// threshold  (0, 1)
/// returns    metres; 0 where C >= 1/t, infinity where L = Q = 0 and C < 1/t
/// max error  kExtentMaxUlp                                                                  (attenuation_test.cpp)
/// throws     std::invalid_argument naming field, value and rule
double compute_extent(const Attenuation& attenuation, double threshold);
float compute_extent(const AttenuationF& attenuation, float threshold);

/// Knee: the range up to which the clamp holds the attenuation at 1, the root of C + L r + Q r^2 = 1.
///
/// returns    metres; 0 where C >= 1, infinity where L = Q = 0 and C < 1
/// max error  kKneeMaxUlp                                                                    (attenuation_test.cpp)
/// throws     std::invalid_argument naming field, value and rule
double compute_knee(const Attenuation& attenuation);

}  // namespace litfog
