// SPDX-License-Identifier: Apache-2.0
#include "litfog/phase.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "reference/digits50.h"
#include "reference/double_limits.h"
#include "reference/random_airlight.h"
#include "reference/ulp.h"

namespace litfog::test {
namespace {

using boost::math::quadrature::gauss_kronrod;

Digits50 exact_lobe(const PhaseLobe& lobe, double cosine) {
  const Digits50 g = lobe.asymmetry, alpha = lobe.alpha, mu = cosine;
  const Digits50 base = 1 + g * g - 2 * g * mu;
  return (1 - g * g) / (base * sqrt(base)) * (1 + alpha * mu * mu) / (1 + alpha * (1 + 2 * g * g) / 3);
}

Digits50 exact_phase(const Phase& phase, double cosine) {
  const Digits50 weight = phase.weight;
  return weight * exact_lobe(phase.first, cosine) + (1 - weight) * exact_lobe(phase.second, cosine);
}

/// The mean over all directions of a function of the cosine times a phase function.
template <typename Function>
double mean(const Phase& phase, const Function& function) {
  return gauss_kronrod<double, 61>::integrate(
             [&](double versine) { return function(1 - versine) * phase_at(phase, 1 - versine); }, 0, 2, 20, 1e-13) /
         2;
}

TEST(Phase, LightIsSpreadOverAllAngles) {
  Random random(92);
  for (int i = 0; i < 200; ++i) {
    const Phase phase = draw_phase(random);
    EXPECT_NEAR(mean(phase, [](double) { return 1; }), 1, 1e-10);
  }
}

TEST(Phase, AsymmetryOfHenyeyAndGreensteinIsTheMeanCosine) {
  for (const double g : {-0.9, -0.3, 0.0, 0.5, 0.95}) {
    const Phase phase = Phase::henyey_greenstein(g);
    EXPECT_NEAR(mean(phase, [](double cosine) { return cosine; }), g, 1e-12) << g;
    EXPECT_EQ(is_isotropic(phase), g == 0) << g;
  }
}

TEST(Phase, AlphaOfOneIsCornetteAndShanksAndRayleigh) {
  for (const double cosine : {-1.0, -0.3, 0.0, 0.7, 1.0}) {
    EXPECT_NEAR(phase_at({.first = {.alpha = 1}}, cosine), 0.75 * (1 + cosine * cosine), 1e-15);
    constexpr double g = 0.6;
    const double expected =
        1.5 * (1 - g * g) / (2 + g * g) * (1 + cosine * cosine) / std::pow(1 + g * g - 2 * g * cosine, 1.5);
    EXPECT_NEAR(phase_at({.first = {g, 1}}, cosine), expected, 1e-14 * expected);
  }
}

// Johannes Jendersie and Eugene d'Eon 2023, section 4: droplets scatter nearly all light ahead, larger ones more.
TEST(Phase, DropletsScatterAhead) {
  double before = 0;
  for (const double micrometres : {5.0, 10.0, 20.0, 50.0}) {
    const Phase phase = Phase::droplets(micrometres);
    ASSERT_FALSE(find_error(phase));
    const double found = mean(phase, [](double cosine) { return cosine; });
    EXPECT_NEAR(mean_cosine(phase), found, 1e-10) << micrometres;
    EXPECT_GT(found, before) << micrometres;
    EXPECT_NEAR(found, 0.85, 0.05) << micrometres;
    before = found;
  }
  const Phase phase = Phase::droplets(10);
  EXPECT_NEAR(phase.first.asymmetry, std::exp(-2.20679 / 13.91029 - 0.428934), 1e-15);
  EXPECT_NEAR(phase.first.alpha, std::exp(3.62489 - 8.29288 / 15.52825), 1e-14);
  EXPECT_NEAR(phase.second.asymmetry, std::exp(-0.0990567 / 8.32846), 1e-15);
  EXPECT_NEAR(phase.weight, std::exp(-0.599085 / 9.358417 - 0.665888), 1e-15);
}

TEST(Phase, DropletsHaveTheirDiameter) {
  Random random(94);
  for (int i = 0; i < 1000; ++i) {
    const double diameter = i < 2 ? (i == 0 ? kSmallestDroplets : kLargestDroplets) : random.uniform(5, 50);
    Phase phase = Phase::droplets(diameter);
    ASSERT_TRUE(droplet_diameter(phase)) << diameter;
    EXPECT_LE(relative_error(*droplet_diameter(phase), diameter), 1e-10);
    for (double* const parameter :
         {&phase.first.asymmetry, &phase.first.alpha, &phase.second.asymmetry, &phase.weight}) {
      const double kept = *parameter;
      for (const double error : {-5e-7, 5e-7}) {
        *parameter = kept * (1 + error);
        EXPECT_TRUE(droplet_diameter(phase)) << diameter;
      }
      *parameter = kept * (1 - 1e-4);
      EXPECT_FALSE(droplet_diameter(phase)) << diameter;
      *parameter = kept;
    }
  }
  for (const double asymmetry : {-0.5, 0.0, 0.3, 0.65, 0.95}) {
    EXPECT_FALSE(droplet_diameter(Phase::henyey_greenstein(asymmetry))) << asymmetry;
  }
}

TEST(Phase, ValueHasFifteenDigitsButForTheCosineItself) {
  Random random(93);
  for (int i = 0; i < 20'000; ++i) {
    const Phase phase = draw_phase(random);
    const double cosine = random.uniform(-1, 1);
    EXPECT_LE(relative_error(phase_at(phase, cosine), exact_phase(phase, cosine)), 1e-10);
  }
}

TEST(Phase, LargestValueBetweenTwoCosinesHasItsStatedError) {
  Random random(91);
  WorstError error("largest_phase", "one lobe", kLargestPhaseMaxError, "relative");
  for (int i = 0; i < 20'000; ++i) {
    Phase phase = draw_phase(random);
    phase.weight = 1;
    const auto draw = [&] {
      const double off = random.chance(0.3) ? 0 : random.log_uniform(1e-15, 2);
      return random.chance(0.5) ? 1 - off : off - 1;
    };
    const double a = draw(), b = draw();
    const double lowest = std::min(a, b), highest = std::max(a, b);
    const Digits50 expected = std::max(exact_phase(phase, lowest), exact_phase(phase, highest));
    error.add(relative_error(largest_phase(phase, lowest, highest), expected),
              [&] { return std::to_string(phase.first.asymmetry); });
    ASSERT_LE(exact_phase(phase, lowest + random.uniform(0, 1) * (highest - lowest)), expected);
  }
  error.check();
  EXPECT_EQ(largest_phase({}), 1);
  for (const double g : {0.5, -0.5}) EXPECT_EQ(largest_phase(Phase::henyey_greenstein(g)), 6) << g;
}

TEST(Phase, LargestValueOfTwoLobesIsNeverBelowTheirSum) {
  Random random(94);
  for (int i = 0; i < 20'000; ++i) {
    const Phase phase = draw_phase(random);
    const double a = random.uniform(-1, 1), b = random.uniform(-1, 1);
    const double between = random.uniform(std::min(a, b), std::max(a, b));
    ASSERT_GE(largest_phase(phase, std::min(a, b), std::max(a, b)) * (1 + 1e-10), phase_at(phase, between));
  }
}

TEST(Phase, WrongMembersAreErrors) {
  const auto error_of = [](const Phase& phase) {
    const auto error = find_error(phase);
    return error ? to_string(*error) : "";
  };
  for (const double g : {-1.0, 1.0, kNan}) {
    EXPECT_TRUE(error_of(Phase::henyey_greenstein(g)).ends_with(": must be in (-1, 1)")) << g;
    EXPECT_TRUE(error_of({.second = {.asymmetry = g}}).starts_with("asymmetry = ")) << g;
  }
  EXPECT_EQ(error_of({.first = {.alpha = -1}}), "alpha = -1: must be in [0, 1e6]");
  EXPECT_EQ(error_of({.weight = 1.5}), "weight = 1.5: must be in [0, 1]");
  EXPECT_EQ(error_of(Phase::henyey_greenstein(0.999)), "");
  for (const double micrometres : {4.9, 50.1, kNan}) {
    EXPECT_THROW(Phase::droplets(micrometres), std::invalid_argument) << micrometres;
  }
}

}  // namespace
}  // namespace litfog::test
