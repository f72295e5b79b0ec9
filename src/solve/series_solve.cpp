// SPDX-License-Identifier: Apache-2.0
#include "series_solve.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "model/level_range.h"
#include "stationary_guess.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "solve/series_solve.cpp"  // this file, once for each target
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

// The method is that of solve.cpp, arranged for a short chain of dependent operations. The depth u is x = d r in exp
// fog and x^2 in exp2 fog.
//
// 1. A guess of the stationary point. Where it is clearly beyond the extent or below the knee, the peak is there.
// 2. Opacity and transmittance at the guess's depth, by the only exponential, and the denominator there, both to more
//    digits than double has.
// 3. A step by the slope's series, reversed to fifth order: it ends within 1e-8 of the peak, whose height is then
//    exact. A step over the extent or the knee ends there.
// 4. The change of e^-u and of the denominator over the step, by short polynomials.
//
// All targets compute the same digits, because every operation here rounds the same on each: nothing is contracted, and
// std::fma is exact everywhere. The targets gain fewer and shorter instructions.

HWY_BEFORE_NAMESPACE();
namespace litfog::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The sum of c[k] x^k, in pairs (Estrin's scheme).
template <std::size_t kCount>
HWY_INLINE double polynomial(const double (&c)[kCount], double x) {
  if constexpr (kCount == 1) {
    return c[0];
  } else {
    double pairs[(kCount + 1) / 2];
    for (std::size_t k = 0; k < kCount / 2; ++k) pairs[k] = c[2 * k] + x * c[2 * k + 1];
    if constexpr (kCount % 2 == 1) pairs[kCount / 2] = c[kCount - 1];
    return polynomial(pairs, x * x);
  }
}

HWY_INLINE Split<double> fast_two_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

/// Opacity and transmittance of fog at an optical depth u.
struct FogLoss {
  Split<double> opacity;  ///< 1 - e^-u
  double fog_factor;      ///< e^-u
  double bend;            ///< 1 - (1 + u) e^-u
};

/// No peak is sought beyond, because 1 - e^-64 is 1.
constexpr double kMaxDepth = 64;

/// The longest step to the root, as a fraction of the depth and as a depth. Of a function like e^u, a step s to fifth
/// order leaves s^6 / 6.
constexpr double kLongestStepOfDepth = 0.03, kLongestStep = 0.08;

HWY_INLINE FogLoss loss_over(const Split<double>& depth) {
  // u = n ln 2 + g with |g| <= ln 2 / 2, to the nearest n in every rounding mode
  constexpr double kLn2 = 0.69314718055994531;
  constexpr double kLn2High = 0x1.62e42feep-1, kLn2Low = 0x1.a39ef35793c76p-33;  // n times the high part is exact
  constexpr double kInteger = 0x1.8p+52;  // added to n, puts n into the lowest bits
  const hn::CappedTag<double, 1> d;
  const double u = std::min(kMaxDepth, depth.high);
  const double rounding = u < kMaxDepth ? depth.low : 0;
  const double n = hn::GetLane(hn::Round(hn::Set(d, u * 1.4426950408889634)));
  const double scale = std::bit_cast<double>(std::bit_cast<std::uint64_t>(1.0) -
                                             (std::bit_cast<std::uint64_t>(n + kInteger) << 52));  // 2^-n
  const double high = u - n * kLn2High;
  const double low = -n * kLn2Low;
  const double g = high + low;
  // (e^-g - 1 + g) / g^2
  static constexpr double kSeries[] = {
      1. / 2,       -1. / 6,       1. / 24,        -1. / 120,      1. / 720,          -1. / 5040,       1. / 40320,
      -1. / 362880, 1. / 3628800., -1. / 39916800, 1. / 479001600, -1. / 6227020800., 1. / 87178291200.};
  const double curve = g * g * polynomial(kSeries, g);
  const Split<double> sum = fast_two_sum(1 - scale, scale * high);
  const double rest = (low + rounding * (1 - g)) - curve;
  const Split<double> opacity = fast_two_sum(sum.high, sum.low + scale * rest);
  // The bend's first term is also exactly 0 if n = 0, and nothing cancels.
  const double bend = (1 - scale * (1 + n * kLn2)) + scale * (u * g - (1 + u) * curve);
  return {opacity, scale - scale * (high + rest), bend};
}

template <FogMode kMode>
HWY_INLINE FogLoss loss_to(double density, const Split<double>& range) {
  Split<double> depth = two_product(density, range.high);
  depth.low += density * range.low;
  if constexpr (kMode == FogMode::exp2) {
    const Split<double> square = two_product(depth.high, depth.high);
    depth = {square.high, square.low + 2 * depth.high * depth.low};
  }
  return loss_over(depth);
}

/// The slope's function over a step from a depth u: a power series in the step. All coefficients are times e^-u.
using SlopeSeries = double[5];

/// The step to the series' root to fifth order, by its reversion.
HWY_INLINE double step_to_root(const SlopeSeries& slope) {
  const double inverse = 1 / slope[1];
  const double h = -slope[0] * inverse;
  const double a = slope[2] * inverse, b = slope[3] * inverse, c = slope[4] * inverse;
  return h * ((1 - a * h) + h * h * ((2 * a * a - b) - h * (5 * a * (a * a - b) + c)));
}

/// The function of exp fog, (a + 2 b u) p(u) + b u^2 - c with p(u) = e^u - 1 - u.
HWY_INLINE double exp_step(double c, double a, double b, double u, const FogLoss& loss) {
  const double growth = a + 2 * b * u, next = growth + 2 * b, opacity = loss.opacity.high;
  return step_to_root({growth * loss.bend + (b * u * u - c) * loss.fog_factor, opacity * next, next / 2 + b * opacity,
                       (next + 4 * b) / 6, (next + 6 * b) / 24});
}

/// The function of exp2 fog, (2 k + b) p(u) - 2 k u - c with k = a / (4 sqrt(u)).
HWY_INLINE double exp2_step(double c, double a, double b, double x, double u, const FogLoss& loss) {
  const double i = 1 / u, k = a / 4 * x * i;
  const double fog_factor = loss.fog_factor, opacity = loss.opacity.high, o = opacity * i, s = loss.bend * i;
  return step_to_root({(2 * k + b) * loss.bend - (2 * k * u + c) * fog_factor,  //
                       b * opacity + k * (2 * opacity - s - fog_factor),
                       (b + k * (2 - 2 * o + i * (1.5 * s + fog_factor / 2))) / 2,
                       (b + k * (2 + i * (4.5 * o - 3 - i * (3.75 * s + 0.75 * fog_factor)))) / 6,
                       (b + k * (2 + i * (i * (9 - 15 * o + i * (13.125 * s + 1.875 * fog_factor)) - 4))) / 24});
}

template <FogMode kMode>
HWY_INLINE std::optional<FogIntensity> solve(const Attenuation& asked, double density, double threshold) {
  constexpr bool kIsExp = kMode == FogMode::exp;
  const auto attenuation = convert<double>(asked);
  const double constant = attenuation.constant, linear = attenuation.linear, quadratic = attenuation.quadratic;
  const Split<double> extent = level_range(attenuation, threshold);
  if (extent.high == 0) return FogIntensity{0, 0, 0, SolveStatus::ok};
  const auto is_below_knee = [&](double range) HWY_ATTR {
    return int(constant < 1) & int(!(constant + range * (linear + range * quadratic) > 1));
  };
  const auto at_level = [&](double level, double range, double opacity) HWY_ATTR {
    return FogIntensity{std::min(level * opacity, 1.0), range, extent.high, SolveStatus::ok};  // rounding may exceed 1
  };

  // The coefficients of the slope are those of the denominator in x = d r, times d^2.
  const double c = constant * density * density, a = linear * density, b = quadratic;
  const double metres = 1 / density;
  const double range = metres * (kIsExp ? stationary_guess::guess_exp(c, a, b) : stationary_guess::guess_exp2(c, a, b));
  constexpr double kClear = 1.015;  // beyond the guess's largest error
  double level = range >= extent.high * kClear ? threshold : is_below_knee(range * kClear) ? 1 : 0;
  if (level > 0) {
    const Split<double> end = level == 1 ? level_range(attenuation, 1.0) : extent;
    const Split<double> opacity = loss_to<kMode>(density, end).opacity;
    return at_level(level, end.high, opacity.high + opacity.low);
  }

  const FogLoss loss = loss_to<kMode>(density, {range, 0});
  const double x = density * range;
  const double u = kIsExp ? x : x * x;
  const double wanted = kIsExp ? exp_step(c, a, b, u, loss) : exp2_step(c, a, b, x, u, loss);
  if (!(std::abs(wanted) <= std::min(kLongestStepOfDepth * u, kLongestStep) && u < kMaxDepth)) return std::nullopt;
  double stretch = metres * (kIsExp ? wanted : wanted / (x * (1 + std::sqrt(1 + wanted / u))));
  double peak = range + stretch;
  level = peak >= extent.high ? threshold : is_below_knee(peak) ? 1 : 0;
  if (level > 0) {
    const Split<double> end = level == 1 ? level_range(attenuation, 1.0) : extent;
    peak = end.high;
    stretch = (end.high - range) + end.low;
  }
  const double x_step = density * stretch;
  const double step = kIsExp ? x_step : x_step * (2 * x + x_step);
  // (1 - e^-s) / s
  static constexpr double kSeries[] = {1,         -1. / 2,   1. / 6,      -1. / 24,    1. / 120,
                                       -1. / 720, 1. / 5040, -1. / 40320, 1. / 362880, -1. / 3628800};
  const double opacity_rise = loss.fog_factor * (step * polynomial(kSeries, step));
  const Split<double> opacity = fast_two_sum(loss.opacity.high, loss.opacity.low + opacity_rise);
  if (level > 0) return at_level(level, peak, opacity.high + opacity.low);

  const Split<double> start = split_denominator(attenuation, range);
  const double rise = stretch * (linear + quadratic * (2 * range + stretch));
  const Split<double> denominator = fast_two_sum(start.high, start.low + rise);
  const double quotient = opacity.high / denominator.high;
  const double intensity = quotient + (opacity.low - quotient * denominator.low) / start.high;
  return FogIntensity{std::min(intensity, 1.0), peak, extent.high, SolveStatus::ok};
}

std::optional<FogIntensity> solve_exp(const Attenuation& attenuation, double density, double threshold) {
  return solve<FogMode::exp>(attenuation, density, threshold);
}
std::optional<FogIntensity> solve_exp2(const Attenuation& attenuation, double density, double threshold) {
  return solve<FogMode::exp2>(attenuation, density, threshold);
}

}  // namespace litfog::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace litfog {

HWY_EXPORT(solve_exp);
HWY_EXPORT(solve_exp2);

std::optional<FogIntensity> solve_by_series(const Attenuation& attenuation, const Fog& fog, double threshold) {
  return fog.mode == FogMode::exp ? HWY_DYNAMIC_DISPATCH(solve_exp)(attenuation, fog.density, threshold)
                                  : HWY_DYNAMIC_DISPATCH(solve_exp2)(attenuation, fog.density, threshold);
}

}  // namespace litfog
#endif
