// SPDX-License-Identifier: Apache-2.0
#include "solve/stationary_guess.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "reference/random_light.h"
#include "reference/ulp.h"

namespace litfog::test {
namespace {

using namespace stationary_guess;

/// e^u - 1 - u
double expm1_minus_argument(double u) {
  if (u > 0.5) return std::expm1(u) - u;
  double sum = 1;
  for (int n = 18; n > 2; --n) sum = 1 + sum * u / n;
  return sum * u * u / 2;
}

/// The x in [1e-30, 50] at which a rising function changes its sign.
template <typename Slope>
double sign_change(const Slope& slope) {
  double low = std::log(1e-30), high = std::log(50);
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (slope(std::exp(middle)) < 0 ? low : high) = middle;
  }
  return std::exp((low + high) / 2);
}

/// Coefficients of a denominator in x; one may be 0.
struct Coefficients {
  double c, a, b;

  explicit Coefficients(Random& random) {
    const int zero = int(random.uniform(0, 4));
    a = zero == 1 ? 0 : random.log_uniform(1e-4, 1e4);
    b = zero == 2 ? 0 : random.log_uniform(1e-4, random.chance(0.3) ? 1e20 : 1e4);
    c = random.log_uniform(1e-14, 1e8);
  }
};

/// The errors of a guess against the root of a slope.
template <typename Guess, typename Slope>
void check_guess(const char* name, double bound, int power, const Guess& guess, const Slope& slope_at) {
  WorstError relative(name, "C/A, C/B 1e-18..1e12", bound, "relative");
  WorstError absolute(std::string(name) + ", depth", "C/A, C/B 1e-18..1e12", kDepthMaxError, "absolute");
  Random random(1);
  for (int i = 0; i < 100'000; ++i) {
    const Coefficients k(random);
    const double x = sign_change([&](double at) { return slope_at(k, at); });
    const double guessed = guess(k.c, k.a, k.b);
    const auto text = [&] {
      return "C " + std::to_string(k.c) + " A " + std::to_string(k.a) + " B " + std::to_string(k.b);
    };
    relative.add(std::abs(guessed / x - 1), text);
    absolute.add(std::abs(std::pow(guessed, power) - std::pow(x, power)), text);
  }
  relative.check();
  absolute.check();
}

TEST(StationaryGuess, ExpGuessIsWithinItsErrors) {
  check_guess("guess_exp", kExpMaxError, 1, guess_exp, [](const Coefficients& k, double x) {
    return (k.a + 2 * k.b * x) * expm1_minus_argument(x) + k.b * x * x - k.c;
  });
}

TEST(StationaryGuess, Exp2GuessIsWithinItsErrors) {
  check_guess("guess_exp2", kExp2MaxError, 2, guess_exp2, [](const Coefficients& k, double x) {
    return (k.a + 2 * k.b * x) * expm1_minus_argument(x * x) - x * (2 * k.c + k.a * x);
  });
}

}  // namespace
}  // namespace litfog::test
