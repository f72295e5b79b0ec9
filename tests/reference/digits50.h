// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>

// Numbers of 50 digits, and how far a computed value is from one. NaN is infinitely wrong.

namespace litfog::test {

/// 50 decimal digits, exponents to 2^+-2^31: no product of doubles leaves its range.
using Digits50 = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;

/// Distance in units in the last place of T at the reference; denorm_min where the reference is subnormal or 0.
/// T's infinity stands for the first value T cannot hold, and so does every reference beyond it.
template <typename T>
double ulp_error(T computed, const Digits50& reference) {
  using Limits = std::numeric_limits<T>;
  if (std::isnan(computed) || boost::multiprecision::isnan(reference)) return std::numeric_limits<double>::infinity();
  const Digits50 first_beyond = ldexp(Digits50(1), Limits::max_exponent);
  const Digits50 clamped = std::clamp(reference, Digits50(-first_beyond), first_beyond);
  const Digits50 value =
      std::isinf(computed) ? (computed > 0 ? first_beyond : Digits50(-first_beyond)) : Digits50(computed);
  int exponent = Limits::min_exponent;
  if (clamped != 0) frexp(clamped, &exponent);
  exponent = std::clamp(exponent, Limits::min_exponent, Limits::max_exponent);
  return static_cast<double>(ldexp(abs(value - clamped), Limits::digits - exponent));
}

/// Distance relative to the reference; 0 where both are equal (infinite or zero).
template <typename T>
double relative_error(T computed, const Digits50& reference) {
  if (std::isnan(computed) || boost::multiprecision::isnan(reference)) return std::numeric_limits<double>::infinity();
  if (Digits50(computed) == reference) return 0;
  return static_cast<double>(abs((Digits50(computed) - reference) / reference));
}

}  // namespace litfog::test
