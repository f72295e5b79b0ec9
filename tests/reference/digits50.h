// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <boost/multiprecision/mpfr.hpp>
#include <cmath>
#include <limits>

// Numbers of 50 digits, and how far a computed value is from one. NaN is infinitely wrong.

namespace litfog::test {

/// 50 decimal digits, exponents to 2^+-2^30: no product of doubles leaves its range. MPFR is a library, compiled and
/// optimised: Boost's own cpp_bin_float would be compiled with each test, and with a sanitizer.
using Digits50 =
    boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<50, boost::multiprecision::allocate_stack>,
                                  boost::multiprecision::et_off>;

/// Distance in units in the last place of T at the reference; denorm_min where the reference is subnormal or 0.
/// T's infinity stands for the first value T cannot hold, and so does every reference beyond it.
template <typename T, typename Wide>
double ulp_error_in(T computed, const Wide& reference) {
  using std::abs, std::clamp, std::frexp, std::isnan, std::ldexp;
  using Limits = std::numeric_limits<T>;
  if (isnan(computed) || isnan(reference)) return std::numeric_limits<double>::infinity();
  const Wide first_beyond = ldexp(Wide(1), Limits::max_exponent);
  const Wide clamped = clamp(reference, Wide(-first_beyond), first_beyond);
  const Wide value = std::isinf(computed) ? (computed > 0 ? first_beyond : Wide(-first_beyond)) : Wide(computed);
  int exponent = Limits::min_exponent;
  // Boost takes MPFR's exponent from the nearest double, which may be a power of two above.
  if (clamped != 0 && abs(Wide(frexp(clamped, &exponent))) < Wide(0.5)) --exponent;
  exponent = clamp(exponent, Limits::min_exponent, Limits::max_exponent);
  return static_cast<double>(ldexp(Wide(abs(Wide(value - clamped))), Limits::digits - exponent));
}
template <typename T>
double ulp_error(T computed, const Digits50& reference) {
  return ulp_error_in(computed, reference);
}
/// The same where a double is the reference, which takes a hundredth of the time.
template <typename T>
double ulp_error(T computed, double reference) {
  return ulp_error_in<T, long double>(computed, reference);
}

/// Distance relative to the reference; 0 where both are equal (infinite or zero).
template <typename T>
double relative_error(T computed, const Digits50& reference) {
  if (std::isnan(computed) || boost::multiprecision::isnan(reference)) return std::numeric_limits<double>::infinity();
  if (Digits50(computed) == reference) return 0;
  return static_cast<double>(abs((Digits50(computed) - reference) / reference));
}
template <typename T>
double relative_error(T computed, double reference) {
  if (double(computed) == reference) return 0;
  const double error = std::abs((double(computed) - reference) / reference);
  return std::isnan(error) ? std::numeric_limits<double>::infinity() : error;
}

}  // namespace litfog::test
