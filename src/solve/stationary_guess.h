// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <hwy/base.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

// First guesses of the stationary point for series_solve.cpp, whose single step raises their error to the fifth power.
// The bits of a double, read as an integer, are its binary logarithm to 0.086; the first estimate takes roots and
// logarithms from them. One substitution into the equation follows, which leaves a known fraction of the estimate's
// error, subtracted in the last line. All constants were fitted together by Nelder and Mead's method;
// stationary_guess_test.cpp asserts the errors. Internal.

namespace litfog::stationary_guess {

/// Largest relative errors of x, and the largest of the depth (x in exp fog, x^2 in exp2 fog).
inline constexpr double kExpMaxError = 0.0125;
inline constexpr double kExp2MaxError = 0.007;
inline constexpr double kDepthMaxError = 0.03;

inline constexpr double kUnit = 0x1p+52;  ///< the bits of a power of two

HWY_INLINE std::int64_t bits_of(double x) { return std::bit_cast<std::int64_t>(x); }

/// 2^offset times a root, from the root's bits minus those of 1.
HWY_INLINE double root_of(std::int64_t bits, double offset) {
  return std::bit_cast<double>(bits + (bits_of(1) + std::int64_t(offset * kUnit)));
}

/// log(1 + x) for x >= 0, relative error 2.4e-3.
HWY_INLINE double rough_log1p(double x) {
  const std::int64_t bits = bits_of(1 + x);
  const double exponent = double(int((bits >> 52) - 1023));
  const double mantissa = std::bit_cast<double>((bits & 0x000fffffffffffff) | bits_of(1)) - 1;
  const double m = std::min(x, mantissa + 0x1p-51);  // below 1 it is x, which 1 + x may lose
  return exponent * 0.69314718055994531 + m * ((1 - 0.48625 * m) + m * m * (0.2625 - 0.0831 * m));
}

/// The root of (a + 2 b x) p(x) + b x^2 = c, p(u) = e^u - 1 - u; substituted as p(x) (a + b (2 x + x^2 / p(x))) = c.
HWY_INLINE double guess_exp(double c, double a, double b) {
  const std::int64_t ratio = bits_of(c) - bits_of(a + 2 * b);
  const double near = root_of(ratio / 2, 0.6494818);
  const double far = 0.7409555 + 0.5024699 * std::max(0.0, double(ratio) / kUnit - 1.346175);
  const double x = std::min(near, far);
  const double scale = 1 + x * (1. / 3 + 0.1833146 * x);  // near 2 p(x) / x^2
  const double above = c * scale, below = a * scale + 2 * b * (x * scale + 1);
  const double y = (2.238402 * above + std::sqrt(above * (19.83534 * below + 0.879151 * above))) * 0.3174103 / below;
  const double next = rough_log1p(y);
  const double left = -1.438908 * b * x * scale / below;
  return next + (next - x) * (left / (2 + 0.6011011 * next - left)) * (next / x);
}

/// The root of (a + 2 b x) p(x^2) = x (2 c + a x). NaN where a = c = 0.
HWY_INLINE double guess_exp2(double c, double a, double b) {
  const std::int64_t b_bits = bits_of(b);
  const double cube_root = root_of((bits_of(a) - b_bits) / 3, 0.7030495);
  const double near = root_of((bits_of(2 * c + a * cube_root) - b_bits) / 4, -0.5591982);
  const double logarithm = double(bits_of(2 * c + a) - bits_of(a + 2 * b)) / kUnit;
  const double far = 1.023085 + 0.1868545 * std::max(0.0, logarithm + 0.8595017);
  const double x = std::min(near, far);
  const double factor = 2 * c + a * x;
  const double above = x * factor, below = a + 2 * b * x;
  const double y = (2.126752 * above + std::sqrt(above * (17.46515 * below + 0.7919013 * above))) * 0.3341094 / below;
  const double square = rough_log1p(y);
  const double next = std::sqrt(square);
  const double left = 1 + a * x / factor - 2 * b * x / below;
  return next + (next - x) * (left / (4 + 1.411436 * square - left)) * (next / x);
}

}  // namespace litfog::stationary_guess
