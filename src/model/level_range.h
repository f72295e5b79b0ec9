// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <hwy/base.h>

#include <cmath>
#include <limits>

#include "litfog/attenuation.h"

// The range at which the attenuation falls to a level, to more digits than T has. Internal: extent and knee are such
// ranges, and the solver also needs their rounding error.

namespace litfog {

/// An unevaluated sum high + low with |low| <= ulp(high).
template <typename T>
struct Split {
  T high;
  T low;
};

template <typename T>
HWY_INLINE Split<T> two_sum(T a, T b) {
  const T sum = a + b;
  const T b_part = sum - a;
  return {sum, (a - (sum - b_part)) + (b - b_part)};
}

template <typename T>
HWY_INLINE Split<T> two_product(T a, T b) {
  const T product = a * b;
  return {product, std::fma(a, b, -product)};
}

/// L r + Q r^2 with its rounding error (compensated Horner).
template <typename T>
HWY_INLINE Split<T> split_rise(const BasicAttenuation<T>& attenuation, T range) {
  const Split<T> quadratic = two_product(attenuation.quadratic, range);
  const Split<T> slope = two_sum(attenuation.linear, quadratic.high);
  const Split<T> rise = two_product(range, slope.high);
  return {rise.high, rise.low + range * (slope.low + quadratic.low)};
}

/// C + L r + Q r^2 with its rounding error.
template <typename T>
HWY_INLINE Split<T> split_denominator(const BasicAttenuation<T>& attenuation, T range) {
  const Split<T> rise = split_rise(attenuation, range);
  const Split<T> sum = two_sum(attenuation.constant, rise.high);
  return {sum.high, sum.low + rise.low};
}

/// The range at which the attenuation's unclamped form 1 / (C + L r + Q r^2) falls to a level in (0, 1]; 0 where it
/// starts at or below the level, infinity where it never falls. The root's form 2 K / (L + sqrt(L^2 + 4 Q K)) does not
/// cancel; one Newton step with the split residual adds the digits.
template <typename T>
HWY_INLINE Split<T> level_range(const BasicAttenuation<T>& attenuation, T level) {
  const auto [constant, linear, quadratic] = attenuation;
  const T scaled_excess = std::fma(-constant, level, T(1));  // 1 - level C, rounded: down to 0 it keeps its sign
  if (!(scaled_excess > 0)) return {0, 0};
  if (linear == 0 && quadratic == 0) return {std::numeric_limits<T>::infinity(), 0};
  const T excess = scaled_excess / level;  // 1/level - C
  const T root = 2 * excess / (linear + std::sqrt(linear * linear + 4 * quadratic * excess));
  // The residual of 1 - level C = level (L r + Q r^2). With C on the other side it would cancel where C nears 1/level.
  const Split<T> product = two_product(constant, level);
  const Split<T> difference = two_sum(T(1), -product.high);
  const T excess_rounding = ((difference.high - scaled_excess) + difference.low) - product.low;
  const Split<T> rise = split_rise(attenuation, root);
  const Split<T> scaled_rise = two_product(level, rise.high);
  const T residual = (scaled_excess - scaled_rise.high) + (excess_rounding - (scaled_rise.low + level * rise.low));
  const Split<T> refined = two_sum(root, residual / (level * (linear + 2 * quadratic * root)));
  return refined;
}

/// True when every value is 0 or within 2^+-100: then no product in level_range or the solver leaves double's range.
/// Other values take the same code in long double, whose exponent has four bits more.
template <typename... Doubles>
bool is_in_safe_range(Doubles... values) {
  static_assert(std::numeric_limits<long double>::max_exponent >= 16384, "litfog needs a long double of wider range");
  const auto is_safe = [](double x) { return int(x == 0) | (int(x >= 0x1p-100) & int(x <= 0x1p+100)); };
  return (is_safe(values) & ...) != 0;  // without branches, which a mix of lights would mispredict
}

/// Coefficients >= 0, with -0 as 0: 1 / -0 is -infinity.
template <typename T>
BasicAttenuation<T> convert(const Attenuation& attenuation) {
  return {std::abs(T(attenuation.constant)), std::abs(T(attenuation.linear)), std::abs(T(attenuation.quadratic))};
}

}  // namespace litfog
