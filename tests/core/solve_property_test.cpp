// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "litfog/solve.h"
#include "reference/double_limits.h"
#include "reference/random_light.h"
#include "reference/reference_solver.h"

// What holds of the intensity by its definition, without a reference: order, bounds, optimality.

namespace litfog::test {
namespace {

constexpr double kUlp = std::numeric_limits<double>::epsilon();
constexpr double kRoundingOfTwo = 4 * kUlp;      // two solves, each exact to 2 ulp
constexpr double kRoundingOfSample = 16 * kUlp;  // a solve's 2, opacity's 4, attenuation's 3, a range off by 3 squared

/// Calls body with random ordinary lights and, one in four, lights over sixty decades.
template <typename Body>
void for_random_lights(int count, const Body& body) {
  Random random(1968);
  for (int i = 0; i < count; ++i) {
    SolveCase c = draw_ordinary_case(random, random.pick(kModes));
    if (random.chance(0.25)) {
      const auto draw = [&] { return random.log_uniform(1e-30, 1e30); };
      c = {{draw(), draw(), draw()}, {c.fog.mode, draw()}, random.log_uniform(1e-30, 0.99)};
    }
    body(random, c);
    if (testing::Test::HasFatalFailure()) return;
  }
}

double intensity_of(const SolveCase& c) { return solve_fog_intensity(c.attenuation, c.fog, c.threshold).intensity; }

TEST(FogIntensityProperty, IntensityRisesWithTheDensity) {
  for_random_lights(1000, [](Random&, SolveCase c) {
    const double density = c.fog.density;
    double last = 0;
    for (int step = -40; step <= 40; ++step) {
      c.fog.density = density * std::pow(1.7, step);
      const double intensity = intensity_of(c);
      ASSERT_GE(intensity, last * (1 - kRoundingOfTwo)) << to_string(c);
      last = intensity;
    }
  });
}

TEST(FogIntensityProperty, IntensityRisesWithTheDensityByEvenTheSmallestSteps) {
  for_random_lights(1000, [](Random&, SolveCase c) {
    double last = 0;
    for (int step = 0; step < 20; ++step) {
      const double intensity = intensity_of(c);
      ASSERT_GE(intensity, last * (1 - kRoundingOfTwo)) << to_string(c);
      last = intensity;
      c.fog.density = std::nextafter(c.fog.density, 1e300);
    }
  });
}

TEST(FogIntensityProperty, IntensityRisesAsTheThresholdFalls) {
  for_random_lights(1000, [](Random&, SolveCase c) {
    double last = 0;
    for (c.threshold = 0.999; c.threshold > 1e-6; c.threshold *= 0.8) {
      const double intensity = intensity_of(c);
      ASSERT_GE(intensity, last * (1 - kRoundingOfTwo)) << to_string(c);
      last = intensity;
    }
  });
}

TEST(FogIntensityProperty, IntensityNeverExceedsTheLightsNearBrightness) {
  for_random_lights(50000, [](Random& random, SolveCase c) {
    if (random.chance(0.5)) c.fog.density = random.log_uniform(1e-3, 1e40);
    ASSERT_LE(intensity_of(c), std::min(1.0, 1 / c.attenuation.constant)) << to_string(c);
  });
}

TEST(FogIntensityProperty, IntensityNeverFallsBelowASampledValue) {
  for_random_lights(1000, [](Random&, const SolveCase& c) {
    const FogIntensity solved = solve_fog_intensity(c.attenuation, c.fog, c.threshold);
    for (const int samples : {16, 64, 256, 1024, 4096}) {
      const double sampled = sample_fog_intensity(c.attenuation, c.fog, c.threshold, samples).intensity;
      ASSERT_LE(sampled, solved.intensity * (1 + kRoundingOfSample)) << to_string(c) << ", " << samples << " samples";
    }
    for (int i = -500; i <= 500; ++i) {  // around the peak, over four decades
      const double range = std::min(solved.peak_range * std::pow(10, 0.004 * i), solved.extent);
      ASSERT_LE(opacity_at(c.fog, range) * attenuation_at(c.attenuation, range),
                solved.intensity * (1 + kRoundingOfSample))
          << to_string(c) << ", range " << range;
    }
  });
}

TEST(FogIntensityProperty, IntensityIsTakenAtThePeakRange) {
  for_random_lights(10000, [](Random&, const SolveCase& c) {
    const FogIntensity solved = solve_fog_intensity(c.attenuation, c.fog, c.threshold);
    const double there = opacity_at(c.fog, solved.peak_range) * attenuation_at(c.attenuation, solved.peak_range);
    ASSERT_NEAR(there, solved.intensity, solved.intensity * kRoundingOfSample) << to_string(c);
  });
}

TEST(FogIntensityProperty, PeakHasNoBetterNeighbourAtAnyScale) {
  for_random_lights(500, [](Random&, const SolveCase& c) {
    const FogIntensity solved = solve_fog_intensity(c.attenuation, c.fog, c.threshold);
    if (solved.extent == 0) return;
    const Digits50 light_extent = reference_extent(c.attenuation, c.threshold);
    const auto height_at = [&](const Digits50& range) {
      return Digits50(reference_opacity(c.fog.mode, c.fog.density, range) *
                      reference_attenuation(c.attenuation, range));
    };
    // The peak range is good to 1e-9, so that a hundred-millionth to either side is worse.
    Digits50 there = 0;  // at the best of the doubles next to it: a knee falls off by their spacing
    for (const double range :
         {std::nextafter(solved.peak_range, 0.0), solved.peak_range, std::nextafter(solved.peak_range, 1e300)}) {
      there = std::max(there, height_at(std::min(Digits50(range), light_extent)));
    }
    for (const double fraction : {2e-8, 1e-6, 1e-4, 1e-2, 0.5}) {
      ASSERT_LE(height_at(Digits50(solved.peak_range) * (1 - fraction)), there) << to_string(c) << ", -" << fraction;
      const Digits50 beyond = Digits50(solved.peak_range) * (1 + fraction);
      if (beyond <= light_extent) {
        ASSERT_LE(height_at(beyond), there) << to_string(c) << ", +" << fraction;
      }
    }
  });
}

}  // namespace
}  // namespace litfog::test
