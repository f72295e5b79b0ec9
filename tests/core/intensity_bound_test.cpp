// SPDX-License-Identifier: Apache-2.0
#include "litfog/intensity_bound.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>

#include "core/value_errors.h"
#include "litfog/solve.h"
#include "reference/double_limits.h"
#include "reference/random_light.h"

namespace litfog::test {
namespace {

constexpr double kUlp = std::numeric_limits<double>::epsilon();

/// Lights over sixty decades, and one in eight over all that doubles can hold.
SolveCase draw_wide_case(Random& random, FogMode mode) {
  const bool is_any = random.chance(0.125);
  const auto draw = [&] { return is_any ? random.any_positive<double>() : random.log_uniform(1e-30, 1e30); };
  const auto draw_or_0 = [&] { return random.chance(0.2) ? 0 : draw(); };
  const double constant = draw_or_0();
  const double linear = draw_or_0();
  const double quadratic = constant == 0 && linear == 0 ? draw() : draw_or_0();
  const double density = random.chance(0.02) ? 0 : random.chance(0.02) ? kInfinity : draw();
  return {{constant, linear, quadratic}, {mode, density}, random.log_uniform(1e-30, 0.99)};
}

TEST(IntensityBound, BoundIsNeverBelowTheIntensityOfOrdinaryLights) {
  constexpr double kStep = 1 / 255.;
  Random random(41);
  int dim = 0;
  int found = 0;
  double excess = 0;
  for (int i = 0; i < scaled_count(1000000); ++i) {
    const SolveCase c = draw_ordinary_case(random, random.pick(kModes));
    const double bound = IntensityBound(c.attenuation, c.threshold).at(c.fog);
    const double intensity = solve_fog_intensity(c.attenuation, c.fog, c.threshold).intensity;
    ASSERT_GE(bound, intensity) << to_string(c);
    ASSERT_LE(bound, 1) << to_string(c);
    if (intensity >= kStep / 2) continue;
    ++dim;
    excess += bound / intensity;
    if (bound < kStep / 2) ++found;
  }
  std::printf("intensity bound: of %d lights below 0.5/255, %.2f %% are found so; bound / intensity %.3f on average\n",
              dim, 100. * found / dim, excess / dim);
}

TEST(IntensityBound, BoundIsNeverBelowTheIntensityOfAnyLight) {
  Random random(42);
  for (int i = 0; i < scaled_count(1000000); ++i) {
    const SolveCase c = draw_wide_case(random, random.pick(kModes));
    const double bound = IntensityBound(c.attenuation, c.threshold).at(c.fog);
    ASSERT_GE(bound, solve_fog_intensity(c.attenuation, c.fog, c.threshold).intensity) << to_string(c);
    ASSERT_LE(bound, 1) << to_string(c);
  }
}

TEST(IntensityBound, BoundExceedsTheIntensityByLessThanHalfTheOpticalDepthOfTheExtent) {
  Random random(43);
  int checked = 0;
  for (int i = 0; i < scaled_count(300000); ++i) {
    SolveCase c = draw_ordinary_case(random, random.pick(kModes));
    c.fog.density = random.log_uniform(1e-7, 1) / compute_extent(c.attenuation, c.threshold);
    if (!std::isfinite(c.fog.density)) continue;
    const double reach = c.fog.density * compute_extent(c.attenuation, c.threshold);
    const double depth = c.fog.mode == FogMode::exp ? reach : reach * reach;
    const double bound = IntensityBound(c.attenuation, c.threshold).at(c.fog);
    const double intensity = solve_fog_intensity(c.attenuation, c.fog, c.threshold).intensity;
    ASSERT_GE(intensity, bound * (1 - depth / 2) * (1 - 64 * kUlp)) << to_string(c);
    ++checked;
  }
  EXPECT_GT(checked, 200000);
}

TEST(IntensityBound, BoundInThinFogIsTheSlope) {
  constexpr double kDensity = 1e-6;
  const auto bound = [](const Attenuation& attenuation, FogMode mode) {
    return IntensityBound(attenuation, 0.05).at({mode, kDensity});
  };
  // Largest r a(r): at the knee (twice; sqrt(C / Q) is 0 and 10), at sqrt(C / Q) = 100, at the extent 50.
  EXPECT_NEAR(bound({0, 0.1, 0}, FogMode::exp) / (kDensity * 10), 1, 64 * kUlp);
  EXPECT_NEAR(bound({0.1, 0.01, 1e-3}, FogMode::exp) / (kDensity * compute_knee({0.1, 0.01, 1e-3})), 1, 64 * kUlp);
  EXPECT_NEAR(bound({1, 0, 1e-4}, FogMode::exp) / (kDensity * 50), 1, 64 * kUlp);
  EXPECT_NEAR(bound({15, 0.1, 0}, FogMode::exp) / (kDensity * 50 * 0.05), 1, 64 * kUlp);
  // Largest r^2 a(r): at the extent, 190 and 50.
  EXPECT_NEAR(bound({1, 0.1, 0}, FogMode::exp2) / (kDensity * kDensity * 190 * 190 * 0.05), 1, 64 * kUlp);
  EXPECT_NEAR(bound({15, 0.1, 0}, FogMode::exp2) / (kDensity * kDensity * 50 * 50 * 0.05), 1, 64 * kUlp);
}

TEST(IntensityBound, BoundInThickFogIsTheNearAttenuation) {
  for (const FogMode mode : kModes) {
    for (const double density : {1e10, 1e300, kInfinity}) {
      EXPECT_EQ(IntensityBound({0.5, 0.1, 0.01}, 0.05).at({mode, density}), 1);
      EXPECT_NEAR(IntensityBound({4, 0.1, 0.01}, 0.05).at({mode, density}), 0.25, 32 * kUlp);
    }
  }
}

TEST(IntensityBound, BoundIsZeroInClearAirAndForALightWithoutExtent) {
  for (const FogMode mode : kModes) {
    for (const Attenuation& attenuation : {Attenuation{1, 0.1, 0.01}, Attenuation{1, 0, 0}, Attenuation{20, 1, 0}}) {
      EXPECT_EQ(IntensityBound(attenuation, 0.05).at({mode, 0}), 0);
    }
    for (const double density : {1e-300, 1e-3, 1e300, kInfinity}) {
      EXPECT_EQ(IntensityBound({20, 0.1, 0.01}, 0.05).at({mode, density}), 0);
      EXPECT_EQ(IntensityBound({1e300, 0, 0}, 0.05).at({mode, density}), 0);
    }
  }
}

TEST(IntensityBound, BoundIsAboveZeroWhereTheIntensityRoundsToZero) {
  constexpr double kSmallest = std::numeric_limits<double>::denorm_min();
  EXPECT_GT(IntensityBound({0, 10, 0}, 0.05).at({FogMode::exp, kSmallest}), 0);
  EXPECT_GT(IntensityBound({0, 10, 0}, 0.05).at({FogMode::exp2, 1e-200}), 0);
}

TEST(IntensityBound, BoundOfALightOfSubnormalExtentIsNotBelowItsIntensity) {
  const Attenuation attenuation{std::nextafter(20.0, 0.0), 1.5e308, 0};
  const FogIntensity solved = solve_fog_intensity(attenuation, {FogMode::exp, 1e308}, 0.05);
  ASSERT_GT(solved.extent, 0);
  ASSERT_GT(solved.intensity, 0);
  EXPECT_GE(IntensityBound(attenuation, 0.05).at({FogMode::exp, 1e308}), solved.intensity);
}

TEST(IntensityBound, BoundOfConstantAttenuationIsItsValueInAnyFog) {
  for (const FogMode mode : kModes) {
    for (const double density : {std::numeric_limits<double>::denorm_min(), 1e-3, kInfinity}) {
      EXPECT_EQ(IntensityBound({0.5, 0, 0}, 0.05).at({mode, density}), 1);
      EXPECT_NEAR(IntensityBound({4, 0, 0}, 0.05).at({mode, density}), 0.25, 32 * kUlp);
    }
  }
}

TEST(IntensityBound, NegativeZeroIsZero) {
  for (const FogMode mode : kModes) {
    for (const double density : {0.0, 1e-300, 1e-3, 0.06, 1e3, kInfinity}) {
      const auto bound = [&](const Attenuation& a) { return IntensityBound(a, 0.05).at({mode, density}); };
      EXPECT_EQ(bound({-0.0, 0.1, 0}), bound({0, 0.1, 0}));
      EXPECT_EQ(bound({1, 0.1, -0.0}), bound({1, 0.1, 0}));
      EXPECT_EQ(bound({1, -0.0, 0.01}), bound({1, 0, 0.01}));
      EXPECT_EQ(bound({0.5, -0.0, -0.0}), bound({0.5, 0, 0}));
    }
    EXPECT_EQ(IntensityBound({1, 0.1, 0}, 0.05).at({mode, -0.0}), 0);
  }
}

TEST(IntensityBound, WrongAttenuationOrThresholdIsAnError) {
  EXPECT_EQ(error_of([] { IntensityBound({-1, 0, 0}, 0.05); }), "attenuation.constant = -1: must be finite and >= 0");
  EXPECT_EQ(error_of([] { IntensityBound({1, 0, 0}, 1); }), "threshold = 1: must be in (0, 1)");
}

}  // namespace
}  // namespace litfog::test
