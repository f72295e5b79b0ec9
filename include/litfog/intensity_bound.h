// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "litfog/attenuation.h"
#include "litfog/fog.h"

namespace litfog {

/// An upper bound of a light's fog colour intensity in any fog, to decide whether the light needs solving.
/// Constructed once per light; each fog then takes a few multiplications and no exponential.
///
/// Proof. With a(r) the attenuation and E the extent, I = sup over r in [0, E] of (1 - f(r)) a(r). From 1 - e^-x <= x:
///   exp:  1 - f <= d r,     so I <= d sup r a(r)      = d M1
///   exp2: 1 - f <= (d r)^2, so I <= d^2 sup r^2 a(r)  = (d S)^2
/// and from 1 - f <= 1 and a(r) <= 1/C: I <= sup a <= min(1, 1/C).
/// - Up to the knee, a = 1 and r a(r) = r rises. Beyond it, r a(r) = 1 / (C/r + L + Q r), which rises up to
///   r = sqrt(C/Q) and falls from there (C = 0: falls, Q = 0: rises). Hence M1 is r a(r) at sqrt(C/Q) clamped to [knee,
///   E].
/// - r^2 a(r) rises everywhere: its derivative beyond the knee has the sign of 2 C + L r. So it is largest at E, where
///   a is the threshold t: S = E sqrt(t).
/// Rounding. All terms are positive, so nothing cancels, and the computed values err by a few ulps of long double: a
/// knee or extent by 2, and sqrt(C/Q) by 2, whose effect is squared because r a(r) is stationary there. They are raised
/// by eight times the batch's largest error: half for an intensity that is computed too high, half for the
/// multiplications of at().
class IntensityBound {
 public:
  /// attenuation  finite, >= 0, not all zero
  /// threshold    (0, 1): attenuation at which the light ends
  /// throws       std::invalid_argument naming field, value and rule
  IntensityBound(const Attenuation& attenuation, double threshold);

  /// fog      scaled for the light's class (see scaled()); density >= 0, infinity is total fog; not checked here
  /// returns  [0, 1], never below the intensity, exact or computed. It exceeds the intensity by less than the fraction
  ///          x / 2, where x is the optical depth of the extent, d E or (d E)^2: tight in thin fog
  ///          (intensity_bound_test.cpp)
  double at(const Fog& fog) const;

 private:
  double highest_attenuation_;  // sup a; 0 for a light below its threshold everywhere
  double exp_reach_;            // M1, metres; infinite for constant attenuation
  double exp2_reach_;           // S, metres; infinite for constant attenuation
};

}  // namespace litfog
