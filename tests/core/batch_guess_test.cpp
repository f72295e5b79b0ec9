// SPDX-License-Identifier: Apache-2.0
#include "solve/batch_guess.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>

// The guesses' formulas in double, their largest errors, and the least error that any value of a constant reaches.

namespace litfog::test {
namespace {

using namespace batch_guess;

/// The least of a function of one variable on [low, high], by golden section.
template <typename Function>
double least(const Function& function, double low, double high) {
  const double ratio = (std::sqrt(5.0) - 1) / 2;
  for (int i = 0; i < 40; ++i) {
    const double left = high - ratio * (high - low);
    const double right = low + ratio * (high - low);
    (function(left) < function(right) ? high : low) = function(left) < function(right) ? right : left;
  }
  return function((low + high) / 2);
}

/// The constants keep their stated error, which no others better by more than a factor.
void check(const char* name, double error, double stated, double least_error, double factor) {
  std::printf("%-24s error %.3g, stated %.3g, least %.3g\n", name, error, stated, least_error);
  EXPECT_LE(error, stated);
  EXPECT_LE(error, factor * least_error);
}

double relative(double value, double truth) { return std::abs(value / truth - 1); }

double log1p_error(double k0, double k1, double k2) {
  double worst = 0;
  for (int i = 1; i <= 1000; ++i) {
    const double m = i / 1000.;
    worst = std::max(worst, relative(m * (1 + m * (k0 + m * (k1 + m * k2))), std::log1p(m)));
  }
  return worst;
}

TEST(BatchGuess, LogarithmIsWithinItsError) {
  const auto error_of = [](double k1, double k2) { return log1p_error(std::log(2.0) - 1 - k1 - k2, k1, k2); };
  const double least_error =
      least([&](double k2) { return least([&](double k1) { return error_of(k1, k2); }, 0.1, 0.5); }, -0.2, 0);
  check("log(1 + m)", log1p_error(kLog1p[0], kLog1p[1], kLog1p[2]), 2.4e-3, least_error, 5);
  EXPECT_NEAR(kLog1p[0] + kLog1p[1] + kLog1p[2], std::log(2.0) - 1, 1e-5);
}

TEST(BatchGuess, CubeRootIsWithinItsError) {
  const auto error_of = [](double constant) {
    double worst = 0;
    for (std::uint32_t bits = 0x3f800000; bits < 0x41000000; bits += 4999) {  // [1, 8): three exponents
      const auto root = std::bit_cast<float>(std::uint32_t(bits / 3. + constant));
      worst = std::max(worst, relative(double(root), std::cbrt(double(std::bit_cast<float>(bits)))));
    }
    return worst;
  };
  check("cube root", error_of(kCubeRootBits), 0.035, least(error_of, 7.095e8, 7.105e8), 1.2);
}

/// e^u - 1 - u.
double excess_of(double u) {
  return u < 1e-2 ? u * u * (1 / 2. + u * (1 / 6. + u * (1 / 24. + u / 120))) : std::expm1(u) - u;
}

double guess_depth(double z, double bend) {
  const double root = std::sqrt(2 * z);
  return std::log1p(z * (1 - 1 / (3 + 3 * bend * root)) + root);
}

TEST(BatchGuess, DepthIsWithinItsError) {
  const auto error_of = [](double bend) {
    double worst = 0;
    for (double u = 1e-4; u < 64; u *= 1.01) worst = std::max(worst, relative(guess_depth(excess_of(u), bend), u));
    return worst;
  };
  check("depth", error_of(kDepthBend), 7e-4, least(error_of, 0.1, 0.3), 2.5);
}

/// Over stationary points x and weights w = 2 B / (A + 2 B), with A + 2 B = 1: the root of (A + 2 B x) p(x) + B x^2 =
/// C.
double exp_error(double damping, double damping_by_weight) {
  double worst = 0;
  for (double x = 1e-4; x < 64; x *= 1.1) {
    for (double w = 0; w <= 1; w += 1 / 16.) {
      const double constant = (1 - w + w * x) * excess_of(x) + w * x * x / 2;
      const double u = guess_depth(constant, kDepthBend);
      worst = std::max(worst, relative(u - std::log1p(w * u * u / (u + damping + damping_by_weight * w)), x));
    }
  }
  return worst;
}

TEST(BatchGuess, StationaryPointInExpFogIsWithinItsError) {
  double least_error = 1;
  for (double k = 2.5; k < 4.5; k += 0.1) {
    for (double l = 0; l < 2; l += 0.1) least_error = std::min(least_error, exp_error(k, l));
  }
  check("exp fog", exp_error(kExpDamping, kExpDampingByWeight), 0.017, least_error, 1.1);
}

/// Over stationary points x and lights with B = 1: 2 C + A x = (A + 2 x) p(x^2) / x.
double exp2_error(double bend) {
  double worst = 0;
  for (double x = 1e-3; x < 8; x *= 1.01) {
    const double p = excess_of(x * x) / x;
    const double most = x > p ? 2 * x * p / (x - p) : 1e3;  // A for C = 0; any where there is none
    for (double fraction = 0; fraction < 1; fraction += 1 / 32.) {
      const double a = fraction * most;
      const double two_c = (a + 2 * x) * p - a * x;
      const double square = std::sqrt(a * std::cbrt(a) + two_c);
      const double z = (two_c + a) / (a + 2);
      const double guess =
          square < kExp2Limit ? std::sqrt(square) * (1 - bend * square) : std::sqrt(std::log(z + 1 + std::sqrt(2 * z)));
      const double next = guess * (a * guess + two_c) / (a + 2 * guess);
      worst = std::max(worst, relative(std::sqrt(guess_depth(next, kDepthBend)), x));
    }
  }
  return worst;
}

TEST(BatchGuess, StationaryPointInExp2FogIsWithinItsError) {
  check("exp2 fog", exp2_error(kExp2Bend), 0.025, least(exp2_error, 0.1, 0.25), 1.1);
}

}  // namespace
}  // namespace litfog::test
