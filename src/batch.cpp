// SPDX-License-Identifier: Apache-2.0
#include "litfog/batch.h"

#include <algorithm>
#include <cassert>
#include <limits>

#include "litfog/solve.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "batch.cpp"  // this file, once for each SIMD target
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// Highway's order: highway.h first.
#include <hwy/contrib/math/math-inl.h>

HWY_BEFORE_NAMESPACE();
namespace litfog::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// The method is that of solve.cpp, a vector of lights at a time: the stationary point by Halley steps in x = d r, then
// one split evaluation at the range chosen. Two things differ. The guess is good enough for one step (float,
// exp fog) or two, since the value is stationary in x. And knee and extent are found only where the stationary point asks for
// them: with D the denominator there, the peak is at the knee where D <= 1 and at the extent where D >= 1 / threshold.

template <class V>
struct Split {
  V high;
  V low;
};

template <class D, class V = hn::Vec<D>>
HWY_INLINE Split<V> two_product(D d, V a, V b) {
  const V product = hn::Mul(a, b);
#if HWY_TARGET == HWY_SSSE3 || HWY_TARGET == HWY_SSE4 || HWY_TARGET == HWY_EMU128 || HWY_TARGET == HWY_SCALAR
  // Without a fused multiply-add: Veltkamp's splitting, Dekker's product.
  const V splitter = hn::Set(d, sizeof(hn::TFromD<D>) == 4 ? 4097 : 134217729);  // 2^12 + 1, 2^27 + 1
  const auto halves = [&](V x) HWY_ATTR {
    const V c = hn::Mul(splitter, x);
    const V high = hn::Sub(c, hn::Sub(c, x));
    return Split<V>{high, hn::Sub(x, high)};
  };
  const Split<V> x = halves(a);
  const Split<V> y = halves(b);
  const V rest =
      hn::Sub(hn::Sub(hn::Sub(product, hn::Mul(x.high, y.high)), hn::Mul(x.low, y.high)), hn::Mul(x.high, y.low));
  return {product, hn::Sub(hn::Mul(x.low, y.low), rest)};
#else
  (void)d;
  return {product, hn::MulSub(a, b, product)};
#endif
}

template <class V>
HWY_INLINE Split<V> two_sum(V a, V b) {
  const V sum = hn::Add(a, b);
  const V b_part = hn::Sub(sum, a);
  return {sum, hn::Add(hn::Sub(a, hn::Sub(sum, b_part)), hn::Sub(b, b_part))};
}

/// The same where |a| >= |b|.
template <class V>
HWY_INLINE Split<V> fast_two_sum(V a, V b) {
  const V sum = hn::Add(a, b);
  return {sum, hn::Sub(b, hn::Sub(sum, a))};
}

/// L r + Q r^2 with its rounding error, as in level_range.h.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Split<V> split_rise(D d, V linear, V quadratic, V range) {
  const Split<V> curve = two_product(d, quadratic, range);
  const Split<V> slope = two_sum(linear, curve.high);
  const Split<V> rise = two_product(d, range, slope.high);
  return {rise.high, hn::MulAdd(range, hn::Add(slope.low, curve.low), rise.low)};
}

constexpr double kSeriesDepth = 0.6875;

/// p(u) = e^u - 1 - u for |u| <= kSeriesDepth, to the precision of the type.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V expm1_minus_argument_series(D d, V u) {
  using T = hn::TFromD<D>;
  constexpr int kTerms = sizeof(T) == 4 ? 9 : 15;  // of u^n / (n + 2)!
  constexpr double kReciprocals[] = {1. / 2,
                                     1. / 6,
                                     1. / 24,
                                     1. / 120,
                                     1. / 720,
                                     1. / 5040,
                                     1. / 40320,
                                     1. / 362880,
                                     1. / 3628800,
                                     1. / 39916800,
                                     1. / 479001600,
                                     1. / 6227020800.,
                                     1. / 87178291200.,
                                     1. / 1307674368000.,
                                     1. / 20922789888000.};
  V sum = hn::Set(d, T(kReciprocals[kTerms - 1]));
  for (int n = kTerms - 2; n >= 0; --n) sum = hn::MulAdd(sum, u, hn::Set(d, T(kReciprocals[n])));
  return hn::Mul(hn::Mul(u, u), sum);
}

/// p(u) for 0 <= u, as good as the place of a peak needs it: 2e-5 in float, the type's precision in double.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V expm1_minus_argument(D d, V u) {
  const V one = hn::Set(d, 1);
  const auto is_small = hn::Le(u, hn::Set(d, kSeriesDepth));
  if constexpr (sizeof(hn::TFromD<D>) == 4) {
    const V series =
        hn::MulAdd(hn::MulAdd(hn::MulAdd(u, hn::Set(d, 1.0f / 100), hn::Set(d, 1.0f / 24)), u, hn::Set(d, 1.0f / 6)), u,
                   hn::Set(d, 0.5f));
    // e^u = 2^n 2^f with n from the exponent's bits and f in [-1/2, 1/2]; at most 2^100, where no peak is.
    const hn::RebindToSigned<D> di;
    const V power = hn::Min(hn::Mul(u, hn::Set(d, 1.44269504f)), hn::Set(d, 100.0f));
    const auto whole = hn::ConvertTo(di, hn::Add(power, hn::Set(d, 0.5f)));  // towards 0 in every rounding mode
    const V f = hn::Sub(power, hn::ConvertTo(d, whole));
    V exponential = hn::MulAdd(f, hn::Set(d, 0.0096181f), hn::Set(d, 0.0555041f));
    exponential = hn::MulAdd(hn::MulAdd(exponential, f, hn::Set(d, 0.2402265f)), f, hn::Set(d, 0.6931472f));
    exponential = hn::MulAdd(exponential, f, one);
    exponential = hn::BitCast(d, hn::Add(hn::BitCast(di, exponential), hn::ShiftLeft<23>(whole)));
    return hn::IfThenElse(is_small, hn::Mul(hn::Mul(u, u), series), hn::Sub(hn::Sub(exponential, one), u));
  } else {
    return hn::IfThenElse(is_small, expm1_minus_argument_series(d, u), hn::Sub(hn::Sub(hn::Exp(d, u), one), u));
  }
}

/// log(1 + x) for x >= 0 to 2e-3 of itself: enough for a guess.
template <class DF, class VF = hn::Vec<DF>>
HWY_INLINE VF rough_log1p(DF df, VF x) {
  const hn::RebindToSigned<DF> di;
  const VF one = hn::Set(df, 1.0f);
  const VF y = hn::Add(one, x);
  const auto bits = hn::BitCast(di, y);
  const VF exponent = hn::ConvertTo(df, hn::Sub(hn::ShiftRight<23>(bits), hn::Set(di, 127)));
  const auto mantissa = hn::Or(hn::And(bits, hn::Set(di, 0x007fffff)), hn::BitCast(di, one));
  const VF m = hn::IfThenElse(hn::Lt(x, one), x, hn::Sub(hn::BitCast(df, mantissa), one));  // x may vanish beside 1
  // log(1 + m) = m - m^2 / 2 + ..., fitted on [0, 1] with the true slope at 0 and value at 1.
  VF log = hn::MulAdd(m, hn::Set(df, -0.0831f), hn::Set(df, 0.2625f));
  log = hn::MulAdd(m, log, hn::Set(df, -0.48625f));
  log = hn::Mul(m, hn::MulAdd(m, log, one));
  return hn::MulAdd(exponent, hn::Set(df, 0.69314718f), log);
}

/// x^(1/3) within 4 %, from the bits: a third of the exponent.
template <class DF, class VF = hn::Vec<DF>>
HWY_INLINE VF rough_cube_root(DF df, VF x) {
  const hn::RebindToSigned<DF> di;
  const VF third = hn::Mul(hn::ConvertTo(df, hn::BitCast(di, x)), hn::Set(df, 1.0f / 3));
  return hn::BitCast(df, hn::Add(hn::ConvertTo(di, third), hn::Set(di, 709921077)));
}

/// a / b to 4e-4: enough for guesses, last steps and corrections in float. Exact in double, where no such instruction
/// is.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V rough_quotient(D, V a, V b) {
  if constexpr (sizeof(hn::TFromD<D>) == 4) {
    return hn::Mul(a, hn::ApproximateReciprocal(b));
  } else {
    return hn::Div(a, b);
  }
}

/// Square root to 4e-4, in float; 0 gives 0.
template <class DF, class VF = hn::Vec<DF>>
HWY_INLINE VF rough_sqrt(DF df, VF x) {
  return hn::Mul(x, hn::ApproximateReciprocalSqrt(hn::Max(x, hn::Set(df, 1e-37f))));
}

/// u with e^u - 1 - u = z, within 5 %.
template <class DF, class VF = hn::Vec<DF>>
HWY_INLINE VF guess_depth(DF df, VF z) {
  return rough_log1p(df, hn::Add(z, rough_sqrt(df, hn::Add(z, z))));
}

/// Guess of the stationary point within 8 %. Constant, A = L / d, B = Q / d^2 as in solve.cpp.
template <class DF, class VF = hn::Vec<DF>>
HWY_INLINE VF guess_stationary_exp(DF df, VF constant, VF a, VF b) {
  const VF two_b = hn::Add(b, b);
  const VF weight = hn::Add(a, two_b);
  const VF x = guess_depth(df, rough_quotient(df, constant, weight));
  // Right where B = 0. For A = 0 the root is lower by log(1 + s), s near x^2 / (x + 2.75).
  const VF share = rough_quotient(df, hn::Mul(two_b, hn::Mul(x, x)), hn::Mul(weight, hn::Add(x, hn::Set(df, 2.75f))));
  return hn::Sub(x, rough_log1p(df, share));
}

/// The same for exp2 fog, within 8 %.
template <class DF, class VF = hn::Vec<DF>>
HWY_INLINE VF guess_stationary_exp2(DF df, VF constant, VF a, VF b) {
  const VF two_c = hn::Add(constant, constant);
  const VF two_b = hn::Add(b, b);
  // p(x^2) = x (2 C + A x) / (A + 2 B x): x = 1 on the right gives a first x, that one the guess.
  const VF far = rough_sqrt(df, guess_depth(df, rough_quotient(df, hn::Add(two_c, a), hn::Add(a, two_b))));
  // Where x is small: x^4 = p x + q with p = A / B, q = 2 C / B, and (p^(4/3) + q)^(1/4) is within 3 %.
  const VF reciprocal = hn::ApproximateReciprocal(hn::Max(b, hn::Set(df, 1e-30f)));
  const VF p = hn::Min(hn::Mul(a, reciprocal), hn::Set(df, 1e20f));
  const VF q = hn::Min(hn::Mul(two_c, reciprocal), hn::Set(df, 1e30f));
  const VF square = rough_sqrt(df, hn::MulAdd(p, rough_cube_root(df, p), q));
  const VF x = hn::IfThenElse(hn::Lt(square, hn::Set(df, 0.5f)), rough_sqrt(df, square), far);
  const VF z = rough_quotient(df, hn::Mul(x, hn::MulAdd(a, x, two_c)), hn::MulAdd(two_b, x, a));
  return rough_sqrt(df, guess_depth(df, z));
}

/// The guess for either precision: made in float.
template <FogMode kMode, class D, class V = hn::Vec<D>>
HWY_INLINE V guess_stationary(D d, V constant, V a, V b) {
  const hn::Rebind<float, D> df;
  const auto guess = [&](auto c, auto l, auto q) HWY_ATTR {
    return kMode == FogMode::exp ? guess_stationary_exp(df, c, l, q) : guess_stationary_exp2(df, c, l, q);
  };
  if constexpr (sizeof(hn::TFromD<D>) == 4) {
    return guess(constant, a, b);
  } else {
    return hn::PromoteTo(d, guess(hn::DemoteTo(df, constant), hn::DemoteTo(df, a), hn::DemoteTo(df, b)));
  }
}

/// A Halley step towards the stationary point; the slopes are those of solve.cpp.
template <FogMode kMode, class D, class V = hn::Vec<D>>
HWY_INLINE V halley_move(D d, V constant, V a, V b, V x) {
  const V one = hn::Set(d, 1);
  const V two_b = hn::Add(b, b);
  V value;
  V first;
  V second;
  if constexpr (kMode == FogMode::exp) {
    const V p = expm1_minus_argument(d, x);
    const V e1 = hn::Add(x, p);
    const V growth = hn::MulAdd(two_b, hn::Add(one, x), a);
    value = hn::MulAdd(hn::MulAdd(two_b, x, a), p, hn::Sub(hn::Mul(b, hn::Mul(x, x)), constant));
    first = hn::Mul(e1, growth);
    second = hn::MulAdd(two_b, e1, hn::Mul(hn::Add(e1, one), growth));
  } else {
    const V w = hn::Mul(x, x);
    const V p = expm1_minus_argument(d, w);
    const V e1 = hn::Add(w, p);
    const V reciprocal = hn::Div(one, x);
    const V half = hn::Mul(hn::Mul(a, hn::Set(d, 0.5)), reciprocal);
    const V growth = hn::Sub(hn::MulAdd(two_b, x, a), hn::Mul(half, reciprocal));
    value = hn::Sub(hn::Sub(hn::Mul(hn::Add(half, b), p), hn::Mul(hn::Mul(a, x), hn::Set(d, 0.5))), constant);
    first = hn::Mul(e1, growth);
    const V bend = hn::MulAdd(half, hn::Mul(reciprocal, reciprocal), b);
    second = hn::MulAdd(hn::Add(x, x), hn::Mul(hn::Add(e1, one), growth), hn::Mul(hn::Add(e1, e1), bend));
  }
  const V two_first = hn::Add(first, first);
  return rough_quotient(d, hn::Mul(two_first, value), hn::Sub(hn::Mul(two_first, first), hn::Mul(value, second)));
}

/// One vector's columns in, and its results.
template <class V>
struct Lanes {
  V constant;
  V linear;
  V quadratic;
  V threshold;
  V density;
};
template <class V, class M>
struct Solved {
  V intensity;
  V peak_range;
  M needs_scalar;  ///< lanes outside the range that the vector arithmetic is sure of, and refused ones
};

/// The range of 2 K / (l + sqrt(l^2 + 4 q K)), 0 where K <= 0; its argument is level * parameter.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V level_root(D d, V excess, V linear, V quadratic) {
  const V twice = hn::Add(excess, excess);
  const V root = hn::Sqrt(hn::MulAdd(linear, linear, hn::Mul(hn::Add(quadratic, quadratic), twice)));
  return hn::IfThenElseZero(hn::Gt(excess, hn::Zero(d)), hn::Div(twice, hn::Add(linear, root)));
}

/// 1 - constant * level with its rounding error.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Split<V> level_excess(D d, V constant, V level) {
  const Split<V> product = two_product(d, constant, level);
  const Split<V> difference = fast_two_sum(hn::Set(d, 1), hn::Neg(product.high));  // dark lights aside
  return {difference.high, hn::Sub(difference.low, product.low)};
}

/// What the range of a level lacks of the true one: a Newton step with the split residual.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V level_correction(D d, const Split<V>& excess, const Lanes<V>& in, V level, V range, const Split<V>& rise) {
  using T = hn::TFromD<D>;
  const Split<V> scaled = two_product(d, level, rise.high);  // the excess, at the true root
  const V residual =
      hn::Add(hn::Sub(hn::Sub(excess.high, scaled.high), scaled.low), hn::NegMulAdd(level, rise.low, excess.low));
  const V slope = hn::Mul(level, hn::MulAdd(hn::Add(in.quadratic, in.quadratic), range, in.linear));
  return rough_quotient(d, residual, hn::Max(slope, hn::Set(d, T(1e-37))));
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE V solve_extent(D d, const Lanes<V>& in) {
  const Split<V> excess = level_excess(d, in.constant, in.threshold);
  const V range = level_root(d, excess.high, hn::Mul(in.threshold, in.linear), hn::Mul(in.threshold, in.quadratic));
  const Split<V> rise = split_rise(d, in.linear, in.quadratic, range);
  const V extent = hn::Add(range, level_correction(d, excess, in, in.threshold, range, rise));
  const V no_fall = hn::Inf(d);
  const auto is_constant = hn::Eq(hn::Add(in.linear, in.quadratic), hn::Zero(d));
  return hn::IfThenElseZero(hn::Gt(excess.high, hn::Zero(d)), hn::IfThenElse(is_constant, no_fall, extent));
}

/// Limit cases go along with harmless values and are replaced at the end: clear air, total fog, constant attenuation.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Lanes<V> without_limit_cases(D d, const Lanes<V>& in) {
  const V zero = hn::Zero(d);
  const V one = hn::Set(d, 1);
  const auto is_limit = hn::Or(hn::Eq(in.density, zero), hn::Eq(in.density, hn::Inf(d)));
  const auto is_constant = hn::Eq(hn::Add(in.linear, in.quadratic), zero);
  return {in.constant, hn::IfThenElse(is_constant, one, in.linear), in.quadratic, in.threshold,
          hn::IfThenElse(is_limit, one, in.density)};
}

/// The denominator in x = d r, as in solve.cpp.
template <class V>
struct ScaledDenominator {
  V constant;
  V linear;     // A = L / d
  V quadratic;  // B = Q / d^2
  V metres;     // 1 / d: r = x metres
};

template <class D, class V = hn::Vec<D>>
HWY_INLINE ScaledDenominator<V> scale_denominator(D d, const Lanes<V>& lanes) {
  const Lanes<V> light = without_limit_cases(d, lanes);
  const V metres = hn::Div(hn::Set(d, 1), light.density);
  return {light.constant, hn::Mul(light.linear, metres), hn::Mul(light.quadratic, hn::Mul(metres, metres)), metres};
}

/// The range of the stationary point from a guess of x: 0 where there is none, NaN where the steps did not settle.
template <FogMode kMode, class D, class V = hn::Vec<D>>
HWY_INLINE V find_stationary(D d, const ScaledDenominator<V>& scaled, V x) {
  using T = hn::TFromD<D>;
  const V zero = hn::Zero(d);
  const V one = hn::Set(d, 1);
  const auto [constant, a, b, metres] = scaled;
  // A step that moves x by the share m leaves at most m^3 (c + x^2 / 12) of it, c = 1/3 for exp and 2 for exp2. The
  // last one has to leave 2e-4 (float), 4e-9 (double): the height is good to its square.
  constexpr bool kIsFloat = sizeof(T) == 4;
  constexpr int kSteps = kIsFloat && kMode == FogMode::exp ? 1 : 2;
  constexpr double kLastMove = !kIsFloat ? 1.2e-3 : kMode == FogMode::exp ? 0.09 : 0.04;
  V move = x;
  for (int step = 0; step < kSteps; ++step) {
    move = halley_move<kMode>(d, constant, a, b, x);
    x = hn::Sub(x, move);
  }
  const V weighted_move = hn::Mul(hn::Abs(move), hn::MulAdd(x, hn::Set(d, T(0.1)), one));
  const auto is_found = hn::And(hn::Gt(x, zero), hn::Lt(weighted_move, hn::Mul(hn::Set(d, T(kLastMove)), x)));
  const auto has_none = kMode == FogMode::exp ? hn::Eq(constant, zero) : hn::Eq(hn::Add(constant, a), zero);
  return hn::IfThenZeroElse(has_none, hn::IfThenElse(is_found, hn::Mul(x, metres), hn::NaN(d)));
}

/// Where the peak is: at a level of the attenuation (1 at the knee, the threshold at the extent), or stationary: level
/// 0. The range lacks its correction.
template <class V>
struct Peak {
  V level;
  V range;
};

template <class D, class V = hn::Vec<D>>
HWY_INLINE Peak<V> place_peak(D d, const Lanes<V>& lanes, V stationary) {
  const V one = hn::Set(d, 1);
  const auto [constant, linear, quadratic, threshold, density] = without_limit_cases(d, lanes);
  const V there = hn::MulAdd(hn::MulAdd(quadratic, stationary, linear), stationary, constant);
  const auto at_extent = hn::Ge(hn::Mul(there, threshold), one);
  const auto at_knee = hn::And(hn::Le(there, one), hn::Lt(constant, one));
  const auto at_level = hn::Or(at_extent, at_knee);
  const V level = hn::IfThenElse(at_extent, threshold, one);
  const V excess = level_excess(d, constant, level).high;
  const V range = level_root(d, excess, hn::Mul(level, linear), hn::Mul(level, quadratic));
  return {hn::IfThenElseZero(at_level, level), hn::IfThenElse(at_level, range, stationary)};
}

/// The intensity at the peak.
template <FogMode kMode, class D, class V = hn::Vec<D>>
HWY_INLINE Solved<V, hn::Mask<D>> solve_peak(D d, const Lanes<V>& in, const Peak<V>& peak) {
  using T = hn::TFromD<D>;
  const V zero = hn::Zero(d);
  const V one = hn::Set(d, 1);
  const Lanes<V> light = without_limit_cases(d, in);
  const V linear = light.linear;
  const V density = light.density;
  const auto [level, range] = peak;
  const auto at_level = hn::Gt(level, zero);
  const Split<V> excess = level_excess(d, in.constant, level);

  const Split<V> rise = split_rise(d, linear, in.quadratic, range);
  const V correction = hn::IfThenElseZero(at_level, level_correction(d, excess, light, level, range, rise));
  Split<V> depth = two_product(d, density, range);
  depth.low = hn::MulAdd(density, correction, depth.low);
  if constexpr (kMode == FogMode::exp2) {
    const Split<V> square = two_product(d, depth.high, depth.high);
    depth = {square.high, hn::MulAdd(hn::Add(depth.high, depth.high), depth.low, square.low)};
  }
  const auto is_thin = hn::Lt(depth.high, hn::Set(d, T(kSeriesDepth)));
  const V minus_depth = hn::Neg(depth.high);
  const V thin = expm1_minus_argument_series(d, hn::IfThenElseZero(is_thin, minus_depth));
  const Split<V> difference = fast_two_sum(hn::IfThenElse(is_thin, depth.high, one),
                                           hn::Neg(hn::IfThenElse(is_thin, thin, hn::Exp(d, minus_depth))));
  const Split<V> opacity{difference.high, hn::MulAdd(hn::Sub(one, difference.high), depth.low, difference.low)};

  const V fall = hn::Add(in.linear, in.quadratic);
  const auto is_clear = hn::Eq(in.density, zero);
  const auto is_total = hn::Eq(in.density, hn::Inf(d));
  const auto is_constant = hn::Eq(fall, zero);
  const auto is_flat = hn::Or(is_total, is_constant);
  const V near = hn::Max(in.constant, one);  // the denominator of a(0+)
  Split<V> denominator = two_sum(in.constant, rise.high);
  denominator.high = hn::IfThenElse(is_flat, near, denominator.high);
  const V reciprocal = hn::Div(one, denominator.high);
  const V quotient = hn::Mul(opacity.high, reciprocal);
  const Split<V> product = two_product(d, quotient, denominator.high);
  const V remainder = hn::Sub(hn::Sub(hn::Sub(opacity.high, product.high), product.low),
                              hn::MulSub(quotient, hn::Add(denominator.low, rise.low), opacity.low));
  const V at_stationary = hn::MulAdd(remainder, reciprocal, quotient);
  V intensity = hn::IfThenElse(at_level, hn::Mul(level, hn::Add(opacity.high, opacity.low)), at_stationary);
  V peak_range = hn::Add(range, correction);

  intensity = hn::IfThenElse(is_flat, reciprocal, intensity);
  peak_range = hn::IfThenElse(is_flat, hn::IfThenElseZero(hn::Not(is_total), hn::Inf(d)), peak_range);
  const auto is_dark = hn::Or(is_clear, hn::Le(level_excess(d, in.constant, in.threshold).high, zero));

  // Squares and cubes of what is within these limits stay within float's range. NaN is outside all limits; the sum of
  // the coefficients is NaN, infinite or 0 where they may not be.
  const V sum = hn::Add(in.constant, fall);
  const V least = hn::Min(in.constant, hn::Min(in.linear, in.quadratic));
  const auto is_safe_attenuation =
      hn::And(hn::And(hn::Gt(sum, zero), hn::Le(sum, hn::Set(d, T(0x1p+20)))),
              hn::And(hn::Ge(least, zero), hn::Or(is_constant, hn::Ge(fall, hn::Set(d, T(0x1p-30))))));
  const auto is_safe_density =
      hn::And(hn::Ge(in.density, hn::Set(d, T(0x1p-17))), hn::Le(in.density, hn::Set(d, T(0x1p+10))));
  const auto is_safe_fog = hn::And(hn::Or(hn::Or(is_clear, is_total), is_safe_density),
                                   hn::And(hn::Ge(in.threshold, hn::Set(d, T(0x1p-14))), hn::Lt(in.threshold, one)));
  const auto is_found = hn::Or(hn::Eq(range, range), hn::Or(is_flat, is_dark));
  intensity = hn::Min(intensity, one);  // rounding upward may exceed it
  return {hn::IfThenZeroElse(is_dark, intensity), hn::IfThenZeroElse(is_dark, peak_range),
          hn::Not(hn::And(hn::And(is_safe_attenuation, is_safe_fog), is_found))};
}

/// A column at a light: one value for all where it has a single one.
template <class D, typename T>
HWY_INLINE hn::Vec<D> load(D d, std::span<const T> column, std::size_t at) {
  return column.size() == 1 ? hn::Set(d, column[0]) : hn::LoadU(d, column.data() + at);
}

template <typename T>
void store(std::span<T> column, std::size_t at, T value) {
  if (!column.empty()) column[at] = value;
}

template <typename T>
T value_at(std::span<const T> column, std::size_t at) {
  return column[column.size() == 1 ? 0 : at];
}

/// One light by the scalar solver: returns whether it is refused.
template <typename T>
bool solve_one(FogMode mode, const BasicBatchLights<T>& lights, const BasicBatchSolutions<T>& solutions,
               std::size_t at) {
  const Attenuation attenuation{lights.constant[at], lights.linear[at], lights.quadratic[at]};
  const Fog fog{mode, value_at(lights.density, at)};
  const double threshold = value_at(lights.threshold, at);
  const bool is_refused = check(attenuation) || check(fog) || check_threshold(threshold);
  const FogIntensity solved =
      is_refused ? FogIntensity{0, 0, 0, SolveStatus::ok} : solve_fog_intensity(attenuation, fog, threshold);
  store(solutions.intensity, at, T(solved.intensity));
  store(solutions.peak_range, at, T(solved.peak_range));
  store(solutions.extent, at, T(solved.extent));
  store(solutions.status, at,
        is_refused                         ? BatchStatus::refused
        : solved.status == SolveStatus::ok ? BatchStatus::ok
                                           : BatchStatus::not_converged);
  return is_refused;
}

template <FogMode kMode, typename T>
std::size_t solve_columns(const BasicBatchLights<T>& lights, const BasicBatchSolutions<T>& solutions) {
  const hn::ScalableTag<T> d;
  const std::size_t lanes = hn::Lanes(d);
  const std::size_t count = solutions.intensity.size();
  std::fill(solutions.status.begin(), solutions.status.end(), BatchStatus::ok);
  std::size_t refused = 0;
  const auto lanes_at = [&](std::size_t at) HWY_ATTR {
    return Lanes<hn::Vec<decltype(d)>>{
        hn::LoadU(d, lights.constant.data() + at), hn::LoadU(d, lights.linear.data() + at),
        hn::LoadU(d, lights.quadratic.data() + at), load(d, lights.threshold, at), load(d, lights.density, at)};
  };
  // In blocks, a stage at a time: each stage alone is short enough for the processor to overlap several vectors of it.
  constexpr std::size_t kBlock = 256;
  T ranges[kBlock];
  T levels[kBlock];
  std::size_t at = 0;
  while (at + lanes <= count) {
    const std::size_t begin = at;
    const std::size_t end = begin + std::min(kBlock, (count - begin) / lanes * lanes);
    for (at = begin; at < end; at += lanes) {
      const auto scaled = scale_denominator(d, lanes_at(at));
      hn::StoreU(guess_stationary<kMode>(d, scaled.constant, scaled.linear, scaled.quadratic), d,
                 ranges + (at - begin));
    }
    for (at = begin; at < end; at += lanes) {
      const auto guess = hn::LoadU(d, ranges + (at - begin));
      hn::StoreU(find_stationary<kMode>(d, scale_denominator(d, lanes_at(at)), guess), d, ranges + (at - begin));
    }
    for (at = begin; at < end; at += lanes) {
      const auto peak = place_peak(d, lanes_at(at), hn::LoadU(d, ranges + (at - begin)));
      hn::StoreU(peak.level, d, levels + (at - begin));
      hn::StoreU(peak.range, d, ranges + (at - begin));
    }
    for (at = begin; at < end; at += lanes) {
      const auto in = lanes_at(at);
      const auto solved =
          solve_peak<kMode>(d, in, {hn::LoadU(d, levels + (at - begin)), hn::LoadU(d, ranges + (at - begin))});
      hn::StoreU(solved.intensity, d, solutions.intensity.data() + at);
      if (!solutions.peak_range.empty()) hn::StoreU(solved.peak_range, d, solutions.peak_range.data() + at);
      if (!solutions.extent.empty()) hn::StoreU(solve_extent(d, in), d, solutions.extent.data() + at);
      if (hn::AllFalse(d, solved.needs_scalar)) continue;
      std::uint8_t bits[8] = {};
      hn::StoreMaskBits(d, solved.needs_scalar, bits);
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        if (bits[lane / 8] >> (lane % 8) & 1) refused += solve_one<T>(kMode, lights, solutions, at + lane);
      }
    }
  }
  // The rest through a padded copy of itself, so that a light's result does not depend on its place.
  if (at < count) {
    constexpr std::size_t kMost = hn::MaxLanes(d);
    T columns[5][kMost];
    T intensity[kMost];
    T peak_range[kMost];
    T extent[kMost];
    BatchStatus status[kMost];
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const std::size_t from = std::min(at + lane, count - 1);  // the last light again
      columns[0][lane] = lights.constant[from];
      columns[1][lane] = lights.linear[from];
      columns[2][lane] = lights.quadratic[from];
      columns[3][lane] = value_at(lights.threshold, from);
      columns[4][lane] = value_at(lights.density, from);
    }
    solve_columns<kMode, T>({.constant = {columns[0], lanes},
                             .linear = {columns[1], lanes},
                             .quadratic = {columns[2], lanes},
                             .threshold = {columns[3], lanes},
                             .density = {columns[4], lanes}},
                            {.intensity = {intensity, lanes},
                             .peak_range = {peak_range, solutions.peak_range.empty() ? 0 : lanes},
                             .extent = {extent, solutions.extent.empty() ? 0 : lanes},
                             .status = {status, lanes}});
    for (std::size_t lane = 0; at + lane < count; ++lane) {
      store(solutions.intensity, at + lane, intensity[lane]);
      store(solutions.peak_range, at + lane, peak_range[lane]);
      store(solutions.extent, at + lane, extent[lane]);
      store(solutions.status, at + lane, status[lane]);
      refused += status[lane] == BatchStatus::refused;
    }
  }
  return refused;
}

std::size_t solve_exp_double(const BatchLights& lights, const BatchSolutions& solutions) {
  return solve_columns<FogMode::exp>(lights, solutions);
}
std::size_t solve_exp2_double(const BatchLights& lights, const BatchSolutions& solutions) {
  return solve_columns<FogMode::exp2>(lights, solutions);
}
std::size_t solve_exp_float(const BatchLightsF& lights, const BatchSolutionsF& solutions) {
  return solve_columns<FogMode::exp>(lights, solutions);
}
std::size_t solve_exp2_float(const BatchLightsF& lights, const BatchSolutionsF& solutions) {
  return solve_columns<FogMode::exp2>(lights, solutions);
}

}  // namespace litfog::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace litfog {
namespace {

template <typename T>
bool has_fitting_columns(const BasicBatchLights<T>& lights, const BasicBatchSolutions<T>& solutions) {
  const std::size_t count = solutions.intensity.size();
  const auto is_whole = [count](const auto& column) { return column.size() == count; };
  const auto is_shared = [&](const auto& column) { return is_whole(column) || column.size() == 1; };
  const auto is_wanted = [&](const auto& column) { return is_whole(column) || column.empty(); };
  return is_whole(lights.constant) && is_whole(lights.linear) && is_whole(lights.quadratic) &&
         is_shared(lights.threshold) && is_shared(lights.density) && is_wanted(solutions.peak_range) &&
         is_wanted(solutions.extent) && is_wanted(solutions.status);
}

}  // namespace

HWY_EXPORT(solve_exp_double);
HWY_EXPORT(solve_exp2_double);
HWY_EXPORT(solve_exp_float);
HWY_EXPORT(solve_exp2_float);

std::size_t solve_fog_intensities(FogMode mode, const BatchLights& lights, const BatchSolutions& solutions) {
  assert(has_fitting_columns(lights, solutions));
  return mode == FogMode::exp ? HWY_DYNAMIC_DISPATCH(solve_exp_double)(lights, solutions)
                              : HWY_DYNAMIC_DISPATCH(solve_exp2_double)(lights, solutions);
}

std::size_t solve_fog_intensities(FogMode mode, const BatchLightsF& lights, const BatchSolutionsF& solutions) {
  assert(has_fitting_columns(lights, solutions));
  return mode == FogMode::exp ? HWY_DYNAMIC_DISPATCH(solve_exp_float)(lights, solutions)
                              : HWY_DYNAMIC_DISPATCH(solve_exp2_float)(lights, solutions);
}

}  // namespace litfog
#endif
