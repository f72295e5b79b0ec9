// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <stdexcept>

#include "litfog/attenuation.h"
#include "litfog/fog.h"
#include "reference/digits50.h"

// The solver's reference to 50 digits: what the model's definitions give for exactly these doubles, by bisection on the
// sign of the derivative. Terms of one sign only are added anywhere, so that no digits cancel at any exponent.

namespace litfog::test {

struct ReferencePeak {
  Digits50 intensity;
  Digits50 peak_range;
  Digits50 extent;
};

/// e^u - 1 - u.
template <typename Real>
Real reference_expm1_minus_argument(const Real& u) {
  using std::abs, std::exp;
  if (abs(u) > Real(0.5)) return exp(u) - 1 - u;
  Real term = u * u / 2;
  Real sum = term;
  for (int n = 3; abs(term) > abs(sum) * std::numeric_limits<Real>::epsilon() / 4; ++n) {
    term *= u / n;
    sum += term;
  }
  return sum;
}

inline Digits50 reference_opacity(FogMode mode, const Digits50& density, const Digits50& range) {
  const Digits50 product = density * range;
  const Digits50 depth = mode == FogMode::exp ? product : Digits50(product * product);
  if (depth > Digits50(0.5)) return depth > 1000 ? Digits50(1) : Digits50(1 - exp(-depth));
  return depth == 0 ? Digits50(0) : Digits50(depth - reference_expm1_minus_argument(Digits50(-depth)));
}

inline Digits50 reference_denominator(const Attenuation& a, const Digits50& range) {
  return Digits50(a.constant) + range * (Digits50(a.linear) + range * Digits50(a.quadratic));
}

inline Digits50 reference_attenuation(const Attenuation& a, const Digits50& range) {
  const Digits50 denominator = reference_denominator(a, range);
  return denominator > 1 ? Digits50(1 / denominator) : Digits50(1);
}

/// Range at which C + L r + Q r^2 = 1/level, for L or Q > 0; 0 where it starts there or beyond. The sign of the
/// polynomial on either side proves the root.
inline Digits50 reference_level_range(const Attenuation& a, double level) {
  const Digits50 constant = a.constant, linear = a.linear, quadratic = a.quadratic, t = level;
  const Digits50 excess = (1 - constant * t) / t;  // the product of two doubles is exact here, and so is the difference
  if (excess <= 0) return 0;
  const Digits50 root = 2 * excess / (linear + sqrt(linear * linear + 4 * quadratic * excess));
  const auto is_beyond = [&](const Digits50& r) { return r * (linear + r * quadratic) > excess; };
  const Digits50 fraction("1e-45");
  if (is_beyond(root * (1 - fraction)) || !is_beyond(root * (1 + fraction)))
    throw std::logic_error("reference: no root");
  return root;
}

inline Digits50 reference_extent(const Attenuation& a, double threshold) { return reference_level_range(a, threshold); }
inline Digits50 reference_knee(const Attenuation& a) { return reference_level_range(a, 1); }

/// True where the derivative of opacity / (C + L r + Q r^2) is negative. With p = expm1(x) - x, the derivative's sign
/// is that of C - Q r^2 - (L + 2 Q r) p(d r) / d in exp fog, of d^2 r (2 C + L r) - (L + 2 Q r) p(d^2 r^2) in exp2 fog.
template <typename Real>
bool is_falling(const Attenuation& a, const Fog& fog, const Real& r) {
  const Real constant = a.constant, linear = a.linear, quadratic = a.quadratic, density = fog.density;
  const Real growth = linear + 2 * quadratic * r;
  const Real depth = density * r;
  // Whatever the doubles, e^10000 outgrows all other factors.
  if (fog.mode == FogMode::exp) {
    return depth > 10000 || quadratic * r * r + growth * reference_expm1_minus_argument(depth) / density > constant;
  }
  return depth > 100 || growth * reference_expm1_minus_argument(Real(depth * depth)) >
                            density * density * r * (2 * constant + linear * r);
}

/// The change from rising to falling in [low, high], to a fraction of itself.
template <typename Real>
Real bisect_peak(const Attenuation& a, const Fog& fog, Real low, Real high, const Real& fraction) {
  using std::sqrt;
  while (high > low * (1 + fraction)) {
    const Real middle = high > 2 * low ? Real(sqrt(low) * sqrt(high)) : Real((low + high) / 2);
    (is_falling(a, fog, middle) ? high : low) = middle;
  }
  return low;
}

/// Extent, peak range (to 1e-13) and intensity (to 1e-20) for 0 < density < infinity and L or Q > 0.
inline ReferencePeak solve_reference(const Attenuation& a, const Fog& fog, double threshold) {
  const Digits50 extent = reference_extent(a, threshold);
  if (extent == 0) return {0, 0, 0};
  const Digits50 knee = reference_knee(a);
  const auto at = [&](const Digits50& range) -> ReferencePeak {
    return {reference_opacity(fog.mode, fog.density, range) * reference_attenuation(a, range), range, extent};
  };
  if (!is_falling(a, fog, extent))
    return {threshold * reference_opacity(fog.mode, fog.density, extent), extent, extent};
  // From the limits of double: no peak of doubles lies nearer to 0 but the one at 0.
  const Digits50 low = std::max(knee, ldexp(Digits50(1), -2200));
  if (is_falling(a, fog, low)) return at(knee);
  // Found in long double, where 50 digits confirm it.
  const auto peak = Digits50(bisect_peak<long double>(a, fog, static_cast<long double>(low) / 2,
                                                      2 * static_cast<long double>(extent), 1e-15L));
  const Digits50 fraction("1e-13");
  if (peak > low && !is_falling(a, fog, Digits50(peak * (1 - fraction))) &&
      is_falling(a, fog, Digits50(peak * (1 + fraction))) && peak < extent) {
    return at(peak);
  }
  return at(bisect_peak(a, fog, low, extent, fraction));
}

}  // namespace litfog::test
