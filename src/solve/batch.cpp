// SPDX-License-Identifier: Apache-2.0
#include "litfog/batch.h"

#include <algorithm>
#include <cassert>

#include "litfog/solve.h"
#include "model/unchecked.h"
#include "solve/batch_guess.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "solve/batch.cpp"  // this file, once for each SIMD target
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// Highway's order: highway.h first.
#include <hwy/contrib/math/math-inl.h>

HWY_BEFORE_NAMESPACE();
namespace litfog::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// The method is that of solve.cpp, a vector of lights at a time, with these differences:
// - The stationary point is sought in float for both precisions: a guess within 3 %, then a single step. The height is
//   stationary there, so float needs no more; double adds the gain of a Newton step, without another exponential.
// - Knee and extent are found only where the stationary point asks for them: with D the denominator there, the peak is
//   at the knee where D <= 1 and at the extent where D >= 1 / threshold.
// - Limit cases, and lights outside the range of the arithmetic, give NaN and are handled afterwards.

/// A light's value in a column that holds one value per light, or a single value for all lights.
template <typename T>
T value_at(std::span<const T> column, std::size_t at) {
  return column[column.size() == 1 ? 0 : at];
}

/// Copies the five values of a light into a lane of vectors.
template <typename T, std::size_t kLanes>
void copy_light(const BasicBatchLights<T>& lights, std::size_t at, T (&columns)[5][kLanes], std::size_t lane) {
  columns[0][lane] = lights.constant[at];
  columns[1][lane] = lights.linear[at];
  columns[2][lane] = lights.quadratic[at];
  columns[3][lane] = value_at(lights.threshold, at);
  columns[4][lane] = value_at(lights.density, at);
}

/// One vector's columns.
template <class V>
struct Lanes {
  V constant;
  V linear;
  V quadratic;
  V threshold;
  V density;
};

/// The range at which l r + q r^2 equals an excess K: 2 K / (l + sqrt(l^2 + 4 q K)); 0 if K <= 0.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V level_root(D d, V excess, V linear, V quadratic) {
  const V twice = hn::Add(excess, excess);
  const V root = hn::Sqrt(hn::MulAdd(linear, linear, hn::Mul(hn::Add(quadratic, quadratic), twice)));
  return hn::IfThenElseZero(hn::Gt(excess, hn::Zero(d)), hn::Div(twice, hn::Add(linear, root)));
}

template <class V>
struct Split {
  V high;
  V low;
};

template <class D, class V = hn::Vec<D>>
HWY_INLINE Split<V> two_product(D d, V a, V b) {
  const V product = hn::Mul(a, b);
#if HWY_NATIVE_FMA
  (void)d;
  return {product, hn::MulSub(a, b, product)};
#else  // Veltkamp's splitting, Dekker's product
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
#endif
}

/// c - a b without the rounding of the product.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V minus_product(D d, V c, V a, V b) {
#if HWY_NATIVE_FMA
  (void)d;
  return hn::NegMulAdd(a, b, c);
#else
  const Split<V> product = two_product(d, a, b);
  return hn::Sub(hn::Sub(c, product.high), product.low);
#endif
}

/// a + b and its rounding error where |a| >= |b|.
template <class V>
HWY_INLINE Split<V> fast_two_sum(V a, V b) {
  const V sum = hn::Add(a, b);
  return {sum, hn::Sub(b, hn::Sub(sum, a))};
}

/// fast_two_sum() for a and b >= 0 in either order.
template <class V>
HWY_INLINE Split<V> two_sum(V a, V b) {
  return fast_two_sum(hn::Max(a, b), hn::Min(a, b));
}

/// C + L r + Q r^2 with its rounding error, as in level_range.h.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Split<V> split_denominator(D d, const Lanes<V>& in, V range) {
  const Split<V> curve = two_product(d, in.quadratic, range);
  const Split<V> slope = two_sum(in.linear, curve.high);
  const Split<V> rise = two_product(d, range, slope.high);
  const Split<V> sum = two_sum(in.constant, rise.high);
  return {sum.high, hn::Add(sum.low, hn::MulAdd(range, hn::Add(slope.low, curve.low), rise.low))};
}

/// e^(+-u), 0 <= u <= kMaxExponent, as 2^(+-n) e^(+-rest) with |rest| <= ln 2 / 2.
constexpr double kMaxExponent = 64;  ///< no peak lies beyond, and 1 - e^-64 is 1

template <class V>
struct ReducedExponent {
  V scale;        ///< 2^n, or 2^-n
  Split<V> rest;  ///< u - n ln 2; its low part lacks the rounding of u
};

enum class Sign { plus, minus };

template <Sign kSign, class D, class V = hn::Vec<D>>
HWY_INLINE ReducedExponent<V> reduce_exponent(D d, V u) {
  using T = hn::TFromD<D>;
  constexpr bool kIsFloat = sizeof(T) == 4;
  constexpr T kLn2High = kIsFloat ? T(0x1.62ep-1) : T(0x1.62e42feep-1);  // short: n times it is exact
  constexpr T kLn2Low = kIsFloat ? T(0x1.0bfbe8e7bcd5ep-15) : T(0x1.a39ef35793c76p-33);
  constexpr T kExponentOne = kIsFloat ? T(0x1.8p+23) : T(0x1.8p+52);  // added to n, puts n into the lowest bits
  constexpr int kMantissaBits = kIsFloat ? 23 : 52;
  const hn::RebindToUnsigned<D> di;
  const V n = hn::Round(hn::Mul(u, hn::Set(d, T(1.4426950408889634))));  // to the nearest in every rounding mode
  const auto exponent = hn::ShiftLeft<kMantissaBits>(hn::BitCast(di, hn::Add(n, hn::Set(d, kExponentOne))));
  const auto one = hn::BitCast(di, hn::Set(d, T(1)));
  const auto scale = kSign == Sign::plus ? hn::Add(one, exponent) : hn::Sub(one, exponent);
  const V high = hn::NegMulAdd(n, hn::Set(d, kLn2High), u);  // exact
  return {hn::BitCast(d, scale), {high, hn::Neg(hn::Mul(n, hn::Set(d, kLn2Low)))}};
}

/// q(f) = (e^f - 1 - f) / f^2 for |f| <= ln 2 / 2, to the precision of the type: its power series.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V exponential_remainder(D d, V f) {
  using T = hn::TFromD<D>;
  constexpr int kTerms = sizeof(T) == 4 ? 7 : 13;  // number of terms f^n / (n + 2)!
  constexpr double kReciprocals[] = {1. / 2,         1. / 6,           1. / 24,          1. / 120,     1. / 720,
                                     1. / 5040,      1. / 40320,       1. / 362880,      1. / 3628800, 1. / 39916800,
                                     1. / 479001600, 1. / 6227020800., 1. / 87178291200.};
  V sum = hn::Set(d, T(kReciprocals[kTerms - 1]));
  for (int n = kTerms - 2; n >= 0; --n) sum = hn::MulAdd(sum, f, hn::Set(d, T(kReciprocals[n])));
  return sum;
}

/// p(u) = e^u - 1 - u, relative error 2e-6, for 0 <= u <= kMaxExponent.
template <class DF, class VF = hn::Vec<DF>>
HWY_INLINE VF expm1_minus_argument(DF df, VF u) {
  const auto [scale, rest] = reduce_exponent<Sign::plus>(df, u);
  const VF f = hn::Add(rest.high, rest.low);
  const VF scaled = hn::Mul(scale, f);
  const VF below = hn::Sub(hn::Add(scaled, hn::Sub(scale, hn::Set(df, 1.0f))), u);  // exactly 0 where n = 0
  return hn::MulAdd(hn::Mul(scaled, f), exponential_remainder(df, f), below);
}

/// Opacity and transmittance of fog of an optical depth.
template <class V>
struct FogLoss {
  Split<V> opacity;  ///< 1 - e^-depth, without cancellation
  V fog_factor;      ///< e^-depth
};

template <class D, class V = hn::Vec<D>>
HWY_INLINE FogLoss<V> fog_loss_at(D d, const Split<V>& depth) {
  const auto [scale, rest] = reduce_exponent<Sign::minus>(d, hn::Min(depth.high, hn::Set(d, kMaxExponent)));
  const V f = hn::Add(rest.high, rest.low);
  const V low = hn::Add(rest.low, hn::NegMulAdd(depth.low, f, depth.low));
  // (1 - scale) + scale (f - f^2 q(-f)); the first is 0 or at least 1/2, a multiple of a power of two.
  const Split<V> sum = fast_two_sum(hn::Sub(hn::Set(d, 1), scale), hn::Mul(scale, rest.high));
  const V bend = hn::NegMulAdd(hn::Mul(f, f), exponential_remainder(d, hn::Neg(f)), low);
  return {fast_two_sum(sum.high, hn::MulAdd(scale, bend, sum.low)),
          hn::NegMulAdd(scale, hn::Add(rest.high, bend), scale)};
}

/// log(1 + x) for x >= 0, relative error 2.4e-3: enough for a guess.
template <class DF, class VF = hn::Vec<DF>>
HWY_INLINE VF rough_log1p(DF df, VF x) {
  const hn::RebindToSigned<DF> di;
  const VF one = hn::Set(df, 1.0f);
  const VF y = hn::Add(one, x);
  const auto bits = hn::BitCast(di, y);
  const VF exponent = hn::ConvertTo(df, hn::Sub(hn::ShiftRight<23>(bits), hn::Set(di, 127)));
  const auto mantissa = hn::Or(hn::And(bits, hn::Set(di, 0x007fffff)), hn::BitCast(di, one));
  const VF m = hn::IfThenElse(hn::Lt(x, one), x, hn::Sub(hn::BitCast(df, mantissa), one));  // x may vanish beside 1
  VF log = hn::MulAdd(m, hn::Set(df, batch_guess::kLog1p[2]), hn::Set(df, batch_guess::kLog1p[1]));
  log = hn::MulAdd(m, log, hn::Set(df, batch_guess::kLog1p[0]));
  log = hn::Mul(m, hn::MulAdd(m, log, one));
  return hn::MulAdd(exponent, hn::Set(df, 0.69314718f), log);
}

/// log y for y >= 1 to 0.06, from the bits: linear between powers of two.
template <class DF, class VF = hn::Vec<DF>>
HWY_INLINE VF rough_log(DF df, VF y) {
  constexpr float kUnit =
      0.69314718f / 8388608;  // ln 2 per exponent, in units of the mantissa's last bit; the exponent's bias is 127
  const hn::RebindToSigned<DF> di;
  return hn::MulAdd(hn::ConvertTo(df, hn::BitCast(di, y)), hn::Set(df, kUnit), hn::Set(df, -127 * 0.69314718f));
}

/// x^(1/3) for x >= 0 within 4 %, from a third of the bits.
template <class DF, class VF = hn::Vec<DF>>
HWY_INLINE VF rough_cube_root(DF df, VF x) {
  const hn::RebindToSigned<DF> di;
  const auto bits = hn::BitCast(di, hn::Abs(x));  // the bits of -0 are far from those of 0
  const VF third = hn::Mul(hn::ConvertTo(df, bits), hn::Set(df, 1.0f / 3));
  return hn::BitCast(df, hn::Add(hn::ConvertTo(di, third), hn::Set(di, batch_guess::kCubeRootBits)));
}

/// a / b to 4e-4 in float, enough for guesses, last steps and corrections. Exact in double, which has no such
/// instruction.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V rough_quotient(D, V a, V b) {
  if constexpr (sizeof(hn::TFromD<D>) == 4) {
    return hn::Mul(a, hn::ApproximateReciprocal(b));
  } else {
    return hn::Div(a, b);
  }
}

/// Square root to 4e-4; 0 gives 0.
template <class DF, class VF = hn::Vec<DF>>
HWY_INLINE VF rough_sqrt(DF df, VF x) {
  return hn::Mul(x, hn::ApproximateReciprocalSqrt(hn::Max(x, hn::Set(df, 1e-37f))));
}

/// u with e^u - 1 - u = z, relative error 3e-3. Right in the first two terms for small z, in the logarithm for large z.
template <class DF, class VF = hn::Vec<DF>>
HWY_INLINE VF guess_depth(DF df, VF z) {
  const VF one = hn::Set(df, 1.0f);
  const VF root = rough_sqrt(df, hn::Add(z, z));
  const VF third =
      rough_quotient(df, hn::Set(df, 1.0f / 3), hn::MulAdd(root, hn::Set(df, batch_guess::kDepthBend), one));
  return rough_log1p(df, hn::MulAdd(z, hn::Sub(one, third), root));
}

/// Guess of the stationary point within 2 %. Constant, a = L / d, b = Q / d^2 as in solve.cpp.
template <class DF, class VF = hn::Vec<DF>>
HWY_INLINE VF guess_stationary_exp(DF df, VF constant, VF a, VF b) {
  const VF two_b = hn::Add(b, b);
  const VF reciprocal = hn::ApproximateReciprocal(hn::Add(a, two_b));
  const VF x = guess_depth(df, hn::Mul(constant, reciprocal));
  // Right if b = 0, else too large.
  const VF weight = hn::Mul(two_b, reciprocal);
  const VF damping = hn::MulAdd(weight, hn::Set(df, batch_guess::kExpDampingByWeight),
                                hn::Add(x, hn::Set(df, batch_guess::kExpDamping)));
  return hn::Sub(x, rough_log1p(df, rough_quotient(df, hn::Mul(weight, hn::Mul(x, x)), damping)));
}

/// A guess of the stationary point in exp2 fog, within 3 %.
template <class DF, class VF = hn::Vec<DF>>
HWY_INLINE VF guess_stationary_exp2(DF df, VF constant, VF a, VF b) {
  const VF two_c = hn::Add(constant, constant);
  const VF two_b = hn::Add(b, b);
  // p(x^2) = x (2 C + a x) / (a + 2 b x): x = 1 on the right gives a first x, which on the right gives the guess.
  const VF z = rough_quotient(df, hn::Add(two_c, a), hn::Add(a, two_b));
  const VF far = rough_sqrt(df, rough_log(df, hn::Add(hn::Add(z, hn::Set(df, 1.0f)), rough_sqrt(df, hn::Add(z, z)))));
  // For small x: x^4 = p x + q with p = a / b, q = 2 C / b, and (p^(4/3) + q)^(1/4) is near.
  const VF reciprocal = hn::ApproximateReciprocal(hn::Max(b, hn::Set(df, 1e-30f)));
  const VF p = hn::Min(hn::Mul(a, reciprocal), hn::Set(df, 1e20f));
  const VF q = hn::Min(hn::Mul(two_c, reciprocal), hn::Set(df, 1e30f));
  const VF square = rough_sqrt(df, hn::MulAdd(p, rough_cube_root(df, p), q));
  const VF near =
      hn::Mul(rough_sqrt(df, square), hn::NegMulAdd(square, hn::Set(df, batch_guess::kExp2Bend), hn::Set(df, 1.0f)));
  const VF x = hn::IfThenElse(hn::Lt(square, hn::Set(df, batch_guess::kExp2Limit)), near, far);
  const VF next = rough_quotient(df, hn::Mul(x, hn::MulAdd(a, x, two_c)), hn::MulAdd(two_b, x, a));
  return rough_sqrt(df, guess_depth(df, next));
}

/// A function that changes its sign at the stationary point, and its derivatives.
template <class VF>
struct Slope {
  VF value;
  VF first;
  VF second;
  VF third;
};

/// The slope of solve.cpp and its derivatives.
template <class DF, class VF = hn::Vec<DF>>
HWY_INLINE Slope<VF> slope_exp(DF df, VF constant, VF a, VF b, VF x) {
  const VF two_b = hn::Add(b, b);
  const VF growth = hn::MulAdd(two_b, x, a);  // D'(x)
  const VF next = hn::Add(growth, two_b);
  const VF p = expm1_minus_argument(df, hn::Min(x, hn::Set(df, float(kMaxExponent))));
  const VF e1 = hn::Add(x, p);
  const VF e = hn::Add(e1, hn::Set(df, 1.0f));
  return {hn::MulAdd(growth, p, hn::MulSub(hn::Mul(b, x), x, constant)), hn::Mul(e1, next),
          hn::MulAdd(two_b, e1, hn::Mul(e, next)), hn::Mul(e, hn::Add(next, hn::Add(two_b, two_b)))};
}

/// The slope of solve.cpp and its derivatives times 2 x, 2 x^2, 2 x^3 and 2 x^4, which saves the divisions; steps are
/// then relative to x.
template <class DF, class VF = hn::Vec<DF>>
HWY_INLINE Slope<VF> slope_exp2(DF df, VF constant, VF a, VF b, VF x) {
  const VF bend = hn::Mul(hn::Add(b, b), x);
  const VF growth = hn::Add(a, bend);  // D'(x)
  const VF w = hn::Mul(x, x);
  const VF p = expm1_minus_argument(df, hn::Min(w, hn::Set(df, float(kMaxExponent))));
  const VF e1 = hn::Add(w, p);
  const VF two_w = hn::Add(w, w);
  const VF steep = hn::Mul(two_w, growth);
  const VF grown = hn::Mul(hn::Add(e1, hn::Set(df, 1.0f)), w);  // w e^w
  const VF rise = hn::Mul(e1, w);
  const VF second = hn::MulAdd(rise, hn::Sub(bend, a), hn::MulAdd(grown, steep, hn::Mul(a, p)));
  const VF inner = hn::MulAdd(two_w, hn::Add(hn::Sub(bend, a), hn::Add(bend, steep)), steep);
  const VF outer = hn::Mul(hn::Mul(a, hn::Set(df, 3.0f)), hn::Sub(rise, p));
  const VF third = hn::MulAdd(grown, inner, outer);
  return {hn::MulSub(growth, p, hn::Mul(x, hn::MulAdd(a, x, hn::Add(constant, constant)))),
          hn::Mul(e1, hn::Sub(steep, a)), hn::Add(second, second), hn::Add(third, third)};
}

enum class Step {
  halley,      ///< leaves the third power of a guess's error, to the 4e-4 of rough_quotient
  householder  ///< the fourth power
};

/// x = d r of the stationary point, in float, by one step from a guess within 3 %: to 4e-5 by Halley's, 3e-6 by
/// Householder's. 0 if there is none, NaN if the guess was farther off.
template <FogMode kMode, Step kStep, class DF, class VF = hn::Vec<DF>>
HWY_INLINE VF find_stationary(DF df, VF constant, VF a, VF b, VF x) {
  const VF one = hn::Set(df, 1.0f);
  const Slope<VF> slope = kMode == FogMode::exp ? slope_exp(df, constant, a, b, x) : slope_exp2(df, constant, a, b, x);
  VF move;
  if constexpr (kStep == Step::halley) {
    const VF two_first = hn::Add(slope.first, slope.first);
    move = rough_quotient(df, hn::Mul(two_first, slope.value),
                          hn::MulSub(two_first, slope.first, hn::Mul(slope.value, slope.second)));
  } else {
    const VF newton = hn::Div(slope.value, slope.first);
    const VF scaled = hn::Mul(newton, hn::ApproximateReciprocal(slope.first));
    const VF half = hn::Mul(hn::Mul(scaled, slope.second), hn::Set(df, 0.5f));
    const VF sixth = hn::Mul(hn::Mul(hn::Mul(scaled, newton), slope.third), hn::Set(df, 1.0f / 6));
    const VF bent = hn::Sub(half, sixth);
    move = hn::MulAdd(newton, rough_quotient(df, bent, hn::Sub(hn::Sub(one, half), bent)), newton);
  }
  if constexpr (kMode == FogMode::exp2) move = hn::Mul(move, x);
  // At large x a step leaves about x^2 times as much. At the smallest x, solve_peak's slope cancels in double.
  constexpr float kLeast = kStep == Step::halley ? 0 : kMode == FogMode::exp ? 1e-7f : 3e-4f;
  const auto is_near =
      hn::And(hn::Lt(hn::Mul(hn::Abs(move), hn::MulAdd(x, hn::Set(df, 0.1f), one)), hn::Mul(x, hn::Set(df, 0.03f))),
              hn::Gt(x, hn::Set(df, kLeast)));
  const auto has_none = hn::Eq(kMode == FogMode::exp ? constant : hn::Add(constant, a), hn::Zero(df));
  return hn::IfThenZeroElse(has_none, hn::IfThenElse(is_near, hn::Sub(x, move), hn::NaN(df)));
}

/// One vector's results.
template <class V>
struct Solved {
  V intensity;
  V peak_range;
};

/// The range at which the attenuation falls to a level, to half the precision of the type; 0 if it starts below.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V rough_level_range(D d, const Lanes<V>& in, V level) {
  const V excess = minus_product(d, hn::Set(d, 1), in.constant, level);
  return level_root(d, excess, hn::Mul(level, in.linear), hn::Mul(level, in.quadratic));
}

/// The difference of the true range of a level from a rough one: a Newton step with the split residual.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V level_correction(D d, const Lanes<V>& in, V level, V range, const Split<V>& denominator) {
  using T = hn::TFromD<D>;
  const V residual = hn::NegMulAdd(level, denominator.low, minus_product(d, hn::Set(d, 1), level, denominator.high));
  const V slope = hn::Mul(level, hn::MulAdd(hn::Add(in.quadratic, in.quadratic), range, in.linear));
  return rough_quotient(d, residual, hn::Max(slope, hn::Set(d, T(1e-37))));
}

/// A light's excess over its threshold at range 0, over 1 / threshold. A product that only rounds to 1 leaves some.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V excess_of(D d, const Lanes<V>& in) {
  return minus_product(d, hn::Set(d, 1), in.constant, in.threshold);
}

/// Lights below their threshold everywhere.
template <class D, class V = hn::Vec<D>>
HWY_INLINE hn::Mask<D> is_dark(D d, const Lanes<V>& in) {
  return hn::Le(excess_of(d, in), hn::Zero(d));
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE V solve_extent(D d, const Lanes<V>& in) {
  const V range = rough_level_range(d, in, in.threshold);
  const V correction = level_correction(d, in, in.threshold, range, split_denominator(d, in, range));
  const auto is_constant = hn::Eq(hn::Add(in.linear, in.quadratic), hn::Zero(d));
  const V extent = hn::IfThenElse(is_constant, hn::Inf(d), hn::Add(range, correction));
  return hn::IfThenZeroElse(is_dark(d, in), extent);
}

/// The peak: at a level of the attenuation (1 at the knee, the threshold at the extent), or stationary (level 0). The
/// range is not yet corrected.
template <class V>
struct Peak {
  V level;
  V range;
};

/// Relative error of the stationary point in double until solve_peak corrects it. A level as near counts as reached.
constexpr double kRoughness = 4e-6;

template <class D, class V = hn::Vec<D>>
HWY_INLINE Peak<V> place_peak(D d, const Lanes<V>& in, V stationary) {
  constexpr double kMargin = sizeof(hn::TFromD<D>) == 4 ? 0 : kRoughness;
  const V one = hn::Set(d, 1);
  // The denominator without the constant, beside which the rise from a constant of almost 1 would round away.
  const auto rise_at = [&](double fraction) HWY_ATTR {
    const V range = fraction == 1 ? stationary : hn::Mul(stationary, hn::Set(d, hn::TFromD<D>(fraction)));
    return hn::Mul(hn::MulAdd(in.quadratic, range, in.linear), range);
  };
  const auto at_extent = hn::Ge(hn::Mul(hn::Add(rise_at(1 + kMargin), in.constant), in.threshold), one);
  const auto at_knee = hn::And(hn::Le(rise_at(1 - kMargin), hn::Sub(one, in.constant)), hn::Lt(in.constant, one));
  const auto at_level = hn::Or(at_extent, at_knee);
  const V level = hn::IfThenElse(at_extent, in.threshold, one);
  return {hn::IfThenElseZero(at_level, level), hn::IfThenElse(at_level, rough_level_range(d, in, level), stationary)};
}

/// The intensity at the peak, for lights that are no limit case. The peak range is NaN if it was not found.
template <FogMode kMode, class D, class V = hn::Vec<D>>
HWY_INLINE Solved<V> solve_peak(D d, const Lanes<V>& in, const Peak<V>& peak) {
  using T = hn::TFromD<D>;
  const V one = hn::Set(d, 1);
  const V zero = hn::Zero(d);
  const auto [level, range] = peak;
  const auto at_level = hn::Gt(level, zero);

  const Split<V> denominator = split_denominator(d, in, range);
  const V correction = hn::IfThenElseZero(at_level, level_correction(d, in, level, range, denominator));
  Split<V> depth = two_product(d, in.density, range);
  depth.low = hn::MulAdd(in.density, correction, depth.low);
  if constexpr (kMode == FogMode::exp2) {
    const V root = hn::Min(depth.high, hn::Set(d, kMaxExponent));
    const Split<V> square = two_product(d, root, root);
    depth = {square.high, hn::MulAdd(hn::Add(root, root), depth.low, square.low)};
  }
  const auto [opacity, fog_factor] = fog_loss_at(d, depth);

  const V reciprocal = hn::Div(one, denominator.high);
  const V quotient = hn::Mul(opacity.high, reciprocal);
  const V remainder = hn::Add(minus_product(d, opacity.high, quotient, denominator.high),
                              hn::NegMulAdd(quotient, denominator.low, opacity.low));
  V peak_range = hn::Add(range, correction);
  V gain = zero;
  if constexpr (sizeof(T) == 8) {
    // The rough stationary point is one Newton step from the true one, and its height is half that step's slope from
    // the peak's: the cube of the roughness is left. From a level the step may only lead back inside.
    const V curve = hn::Mul(in.quadratic, range);
    const V growth = hn::Add(in.linear, hn::Add(curve, curve));
    V fading;  // opacity'
    V fall;    // -opacity''
    if constexpr (kMode == FogMode::exp) {
      fading = hn::Mul(fog_factor, in.density);
      fall = hn::Mul(fading, in.density);
    } else {
      const V squared = hn::Mul(in.density, in.density);
      const V twice = hn::Mul(fog_factor, hn::Add(squared, squared));
      fading = hn::Mul(twice, range);
      fall = hn::Mul(twice, hn::Sub(hn::Add(depth.high, depth.high), one));
    }
    const V slope = hn::MulSub(fading, denominator.high, hn::Mul(growth, opacity.high));
    const V inward = hn::IfThenElse(hn::Eq(level, one), hn::Max(slope, zero), hn::Min(slope, zero));
    const V wanted = hn::IfThenElse(at_level, inward, slope);
    const V bend = hn::MulAdd(fall, denominator.high, hn::Mul(hn::Add(in.quadratic, in.quadratic), opacity.high));
    const V move = hn::IfThenZeroElse(hn::Eq(wanted, zero), hn::Div(wanted, bend));
    gain = hn::Mul(hn::Mul(move, slope), hn::Mul(hn::Set(d, 0.5), reciprocal));
    const auto is_near = hn::Le(hn::Abs(move), hn::Mul(range, hn::Set(d, kRoughness)));
    peak_range = hn::IfThenElse(is_near, hn::Add(peak_range, move), hn::NaN(d));
  }
  const V at_stationary = hn::MulAdd(hn::Add(remainder, gain), reciprocal, quotient);
  const V at_border = hn::MulAdd(gain, reciprocal, hn::Mul(level, hn::Add(opacity.high, opacity.low)));
  const V intensity = hn::IfThenElse(at_level, at_border, at_stationary);
  return {hn::Min(intensity, one), peak_range};  // rounding upward may exceed 1
}

/// Within these limits squares and cubes stay within float's range. NaN is outside all limits. The sum of the
/// coefficients is NaN, infinite or 0 if they are invalid.
template <class D, class V = hn::Vec<D>>
HWY_INLINE hn::Mask<D> is_safe(D d, const Lanes<V>& in, hn::Mask<D> has_safe_fall) {
  using T = hn::TFromD<D>;
  const V sum = hn::Add(in.constant, hn::Add(in.linear, in.quadratic));
  const V least = hn::Min(in.constant, hn::Min(in.linear, in.quadratic));
  const auto is_safe_attenuation =
      hn::And(hn::And(hn::Le(sum, hn::Set(d, T(0x1p+20))), has_safe_fall), hn::Ge(least, hn::Zero(d)));
  const auto is_safe_threshold =
      hn::And(hn::Ge(in.threshold, hn::Set(d, T(0x1p-14))), hn::Lt(in.threshold, hn::Set(d, 1)));
  return hn::And(is_safe_attenuation, is_safe_threshold);
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE hn::Mask<D> has_least_fall(D d, V fall) {
  return hn::Ge(fall, hn::Set(d, hn::TFromD<D>(0x1p-30)));
}

/// The least excess of lights for which vectors do. For barely lit lights the denominator's digits cancel.
constexpr double kLeastExcess = 0x1p-10;

/// The lights for which solve_peak is valid. Barely lit ones are not; at a threshold next to 1 the knee and the extent
/// are both within kRoughness of the stationary point.
template <class D, class V = hn::Vec<D>>
HWY_INLINE hn::Mask<D> is_ordinary(D d, const Lanes<V>& in) {
  using T = hn::TFromD<D>;
  const auto is_safe_density =
      hn::And(hn::Ge(in.density, hn::Set(d, T(0x1p-17))), hn::Le(in.density, hn::Set(d, T(0x1p+10))));
  const V least_excess = hn::Min(excess_of(d, in), hn::Sub(hn::Set(d, 1), in.threshold));
  return hn::And(is_safe(d, in, has_least_fall(d, hn::Add(in.linear, in.quadratic))),
                 hn::And(hn::Ge(least_excess, hn::Set(d, T(kLeastExcess))), is_safe_density));
}

/// The limit cases among the other lights: clear air, total fog, constant attenuation, dark lights; not barely lit
/// ones, for their extent. The peak range is NaN in all other lanes.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Solved<V> solve_limit_cases(D d, const Lanes<V>& in) {
  const V one = hn::Set(d, 1);
  const V zero = hn::Zero(d);
  const V infinity = hn::Inf(d);
  const V fall = hn::Add(in.linear, in.quadratic);
  const auto is_constant = hn::And(hn::Eq(fall, zero), hn::Gt(in.constant, zero));
  const auto is_valid = hn::And(is_safe(d, in, hn::Or(is_constant, has_least_fall(d, fall))), hn::Ge(in.density, zero));
  const auto is_total = hn::Eq(in.density, infinity);
  const auto is_unlit = hn::Or(hn::Eq(in.density, zero), is_dark(d, in));
  const V excess = excess_of(d, in);
  const auto is_barely_lit = hn::And(hn::Gt(excess, zero), hn::Lt(excess, hn::Set(d, hn::TFromD<D>(kLeastExcess))));
  const auto is_limit = hn::AndNot(is_barely_lit, hn::And(is_valid, hn::Or(is_unlit, hn::Or(is_total, is_constant))));
  const V intensity = hn::IfThenZeroElse(is_unlit, hn::Div(one, hn::Max(in.constant, one)));  // a(0+)
  const V peak_range = hn::IfThenZeroElse(hn::Or(is_unlit, is_total), infinity);
  return {intensity, hn::IfThenElse(is_limit, peak_range, hn::NaN(d))};
}

/// Loads a column from a light on; a column of a single value gives it to all lanes.
template <class D, typename T>
HWY_INLINE hn::Vec<D> load(D d, std::span<const T> column, std::size_t at) {
  return column.size() == 1 ? hn::Set(d, column[0]) : hn::LoadU(d, column.data() + at);
}

template <typename T>
void store(std::span<T> column, std::size_t at, T value) {
  if (!column.empty()) column[at] = value;
}

/// Solves one light by the scalar solver. Returns whether it is invalid.
template <typename T>
bool solve_one(FogMode mode, const BasicBatchLights<T>& lights, const BasicBatchSolutions<T>& solutions, std::size_t at,
               T& peak_range) {
  const Attenuation attenuation{lights.constant[at], lights.linear[at], lights.quadratic[at]};
  const Fog fog{mode, value_at(lights.density, at)};
  const double threshold = value_at(lights.threshold, at);
  const bool is_invalid = find_error(attenuation) || find_error(fog) || find_threshold_error(threshold);
  const FogIntensity solved =
      is_invalid ? FogIntensity{0, 0, 0, SolveStatus::ok} : unchecked::solve_fog_intensity(attenuation, fog, threshold);
  store(solutions.intensity, at, T(solved.intensity));
  peak_range = T(solved.peak_range);
  store(solutions.extent, at, T(solved.extent));
  store(solutions.status, at,
        is_invalid                         ? BatchStatus::invalid
        : solved.status == SolveStatus::ok ? BatchStatus::ok
                                           : BatchStatus::not_converged);
  return is_invalid;
}

// Lights are solved in blocks, a stage at a time. Each stage is short enough for the processor to overlap several
// vectors.
constexpr std::size_t kBlock = 256;

/// x of the stationary points of a block's lights, in float.
template <FogMode kMode, Step kStep>
HWY_INLINE void find_stationary_points(const BasicBatchLights<float>& lights, std::size_t begin, std::size_t count,
                                       float* x) {
  const hn::ScalableTag<float> df;
  float a[kBlock];
  float b[kBlock];
  const auto load_constant = [&](std::size_t k) HWY_ATTR { return hn::LoadU(df, lights.constant.data() + begin + k); };
  for (std::size_t k = 0; k < count; k += hn::Lanes(df)) {
    const auto metres = hn::Div(hn::Set(df, 1.0f), load(df, lights.density, begin + k));
    const auto linear = hn::Mul(hn::LoadU(df, lights.linear.data() + begin + k), metres);
    const auto quadratic = hn::Mul(hn::LoadU(df, lights.quadratic.data() + begin + k), hn::Mul(metres, metres));
    const auto guess = kMode == FogMode::exp ? guess_stationary_exp(df, load_constant(k), linear, quadratic)
                                             : guess_stationary_exp2(df, load_constant(k), linear, quadratic);
    hn::StoreU(linear, df, a + k);
    hn::StoreU(quadratic, df, b + k);
    hn::StoreU(guess, df, x + k);
  }
  for (std::size_t k = 0; k < count; k += hn::Lanes(df)) {
    hn::StoreU(find_stationary<kMode, kStep>(df, load_constant(k), hn::LoadU(df, a + k), hn::LoadU(df, b + k),
                                             hn::LoadU(df, x + k)),
               df, x + k);
  }
}

template <class D, typename T>
HWY_INLINE Lanes<hn::Vec<D>> load_lanes(D d, const BasicBatchLights<T>& lights, std::size_t at) {
  return {hn::LoadU(d, lights.constant.data() + at), hn::LoadU(d, lights.linear.data() + at),
          hn::LoadU(d, lights.quadratic.data() + at), load(d, lights.threshold, at), load(d, lights.density, at)};
}

/// The ranges of the stationary points of a block's lights.
template <FogMode kMode>
HWY_INLINE void find_stationary_ranges(const BasicBatchLights<float>& lights, std::size_t begin, std::size_t count,
                                       float* ranges) {
  const hn::ScalableTag<float> d;
  find_stationary_points<kMode, Step::halley>(lights, begin, count, ranges);
  for (std::size_t k = 0; k < count; k += hn::Lanes(d)) {
    hn::StoreU(hn::Div(hn::LoadU(d, ranges + k), load(d, lights.density, begin + k)), d, ranges + k);
  }
}
template <FogMode kMode>
HWY_INLINE void find_stationary_ranges(const BasicBatchLights<double>& lights, std::size_t begin, std::size_t count,
                                       double* ranges) {
  const hn::ScalableTag<double> d;
  const hn::Rebind<float, decltype(d)> df;
  float columns[4][kBlock];
  float x[kBlock];
  for (std::size_t k = 0; k < count; k += hn::Lanes(d)) {
    const auto in = load_lanes(d, lights, begin + k);
    hn::StoreU(hn::DemoteTo(df, in.constant), df, columns[0] + k);
    hn::StoreU(hn::DemoteTo(df, in.linear), df, columns[1] + k);
    hn::StoreU(hn::DemoteTo(df, in.quadratic), df, columns[2] + k);
    hn::StoreU(hn::DemoteTo(df, in.density), df, columns[3] + k);
  }
  const auto column = [&](int k) { return std::span<const float>(columns[k], count); };
  find_stationary_points<kMode, Step::householder>({column(0), column(1), column(2), {}, column(3)}, 0, count, x);
  for (std::size_t k = 0; k < count; k += hn::Lanes(d)) {
    hn::StoreU(hn::Div(hn::PromoteTo(d, hn::LoadU(df, x + k)), load(d, lights.density, begin + k)), d, ranges + k);
  }
}

/// Solves what solve_block leaves: limit cases in vectors, the rest by the scalar solver. Returns the number of invalid
/// lights.
template <FogMode kMode, typename T>
HWY_NOINLINE std::size_t solve_rest(const BasicBatchLights<T>& lights, const BasicBatchSolutions<T>& solutions,
                                    std::size_t begin, std::size_t count, T* ranges) {
  const hn::ScalableTag<T> d;
  std::size_t invalid = 0;
  for (std::size_t k = 0; k < count; k += hn::Lanes(d)) {
    const auto range = hn::LoadU(d, ranges + k);
    const auto is_missing = hn::IsNaN(range);
    if (hn::AllFalse(d, is_missing)) continue;
    T* const intensities = solutions.intensity.data() + begin + k;
    const auto limit = solve_limit_cases(d, load_lanes(d, lights, begin + k));
    hn::StoreU(hn::IfThenElse(is_missing, limit.peak_range, range), d, ranges + k);
    hn::StoreU(hn::IfThenElse(is_missing, limit.intensity, hn::LoadU(d, intensities)), d, intensities);
    for (std::size_t lane = k; lane < k + hn::Lanes(d); ++lane) {
      if (ranges[lane] != ranges[lane]) invalid += solve_one<T>(kMode, lights, solutions, begin + lane, ranges[lane]);
    }
  }
  return invalid;
}

/// Solves a block of whole vectors.
template <FogMode kMode, typename T>
HWY_INLINE std::size_t solve_block(const BasicBatchLights<T>& lights, const BasicBatchSolutions<T>& solutions,
                                   std::size_t begin, std::size_t count) {
  const hn::ScalableTag<T> d;
  T ranges[kBlock];
  T levels[kBlock];
  find_stationary_ranges<kMode>(lights, begin, count, ranges);
  for (std::size_t k = 0; k < count; k += hn::Lanes(d)) {
    const auto peak = place_peak(d, load_lanes(d, lights, begin + k), hn::LoadU(d, ranges + k));
    hn::StoreU(peak.level, d, levels + k);
    hn::StoreU(peak.range, d, ranges + k);
  }
  auto sum = hn::Zero(d);
  for (std::size_t k = 0; k < count; k += hn::Lanes(d)) {
    const auto in = load_lanes(d, lights, begin + k);
    const auto solved = solve_peak<kMode>(d, in, {hn::LoadU(d, levels + k), hn::LoadU(d, ranges + k)});
    const auto range = hn::IfThenElse(is_ordinary(d, in), solved.peak_range, hn::NaN(d));
    sum = hn::Add(sum, range);  // NaN where any is
    hn::StoreU(solved.intensity, d, solutions.intensity.data() + begin + k);
    hn::StoreU(range, d, ranges + k);
  }
  if (!solutions.extent.empty()) {
    for (std::size_t k = 0; k < count; k += hn::Lanes(d)) {
      hn::StoreU(solve_extent(d, load_lanes(d, lights, begin + k)), d, solutions.extent.data() + begin + k);
    }
  }
  const bool is_whole = hn::AllFalse(d, hn::IsNaN(sum));
  const std::size_t invalid = is_whole ? 0 : solve_rest<kMode>(lights, solutions, begin, count, ranges);
  if (!solutions.peak_range.empty()) std::copy_n(ranges, count, solutions.peak_range.begin() + std::ptrdiff_t(begin));
  return invalid;
}

template <FogMode kMode, typename T>
std::size_t solve_columns(const BasicBatchLights<T>& lights, const BasicBatchSolutions<T>& solutions) {
  const std::size_t lanes = hn::Lanes(hn::ScalableTag<float>());  // whole vectors of either type
  const std::size_t count = solutions.intensity.size();
  std::fill(solutions.status.begin(), solutions.status.end(), BatchStatus::ok);
  std::size_t invalid = 0;
  std::size_t at = 0;
  while (at + lanes <= count) {
    const std::size_t block = std::min(kBlock, (count - at) / lanes * lanes);
    invalid += solve_block<kMode>(lights, solutions, at, block);
    at += block;
  }
  // The rest through a padded copy of itself, so that a light's result does not depend on its position.
  if (at < count) {
    constexpr std::size_t kMost = hn::MaxLanes(hn::ScalableTag<float>());
    T columns[5][kMost];
    T intensity[kMost];
    T peak_range[kMost];
    T extent[kMost];
    BatchStatus status[kMost];
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      copy_light(lights, std::min(at + lane, count - 1), columns, lane);  // the last light again
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
      invalid += status[lane] == BatchStatus::invalid;
    }
  }
  return invalid;
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
