// SPDX-License-Identifier: Apache-2.0
#include "bench/glow_rival.h"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <functional>
#include <numbers>

#include "measure/inverse_square_lamp.h"
#include "litfog/airlight.h"

namespace litfog::bench {
namespace {

using std::numbers::pi;

/// Of a function of the angle to the lamp, over all directions.
double integral(const std::function<double(double)>& value) {
  return boost::math::quadrature::gauss_kronrod<double, 61>::integrate(
      [&](double angle) { return 2 * pi * std::sin(angle) * value(angle); }, 0, pi, 12, 1e-10);
}

TEST(GlowRival, NetFluxOfTheAtmosphericPointSpreadFunctionIsTheLamps) {
  for (const double mean_cosine : {0.0, 0.5, 0.85}) {
    for (const double depth : {1.5, 3.0, 6.0}) {
      const double flux =
          integral([&](double angle) { return std::cos(angle) * apsf_glow(mean_cosine, depth, angle); });
      EXPECT_NEAR(flux * depth * depth / (4 * pi), 1, 1e-8) << mean_cosine << " " << depth;
    }
  }
  EXPECT_TRUE(std::isnan(apsf_glow(0.5, 1, 0.1)));
}

TEST(GlowRival, NarrowGaussianHasTheScatteredLightAndItsMeanSquareAngle) {
  const double mean_cosine = 0.9995;
  for (const double depth : {0.3, 1.0, 6.0}) {
    const double light = integral([&](double angle) { return gaussian_glow(mean_cosine, depth, angle); });
    const double squares =
        integral([&](double angle) { return angle * angle * gaussian_glow(mean_cosine, depth, angle); });
    EXPECT_NEAR(light * depth * depth / (4 * pi), 1 - std::exp(-depth), 1e-3) << depth;
    EXPECT_NEAR(squares * depth * depth / (4 * pi) / (2 / 3. * (1 - mean_cosine) * depth), 1, 1e-2) << depth;
  }
}

TEST(GlowRival, OctavesAreAirlightsInEverThinnerFog) {
  const Phase phase{{0.8, 0.5}, {-0.3, 0}, 0.7};
  for (const double depth : {0.3, 3.0}) {
    for (const double angle : {0.3, 1.0, 2.5}) {
      double sum = 0;
      for (const double part : {1.0, 0.5, 0.25}) {
        Phase flattened = phase;
        flattened.first.asymmetry *= part;
        flattened.second.asymmetry *= part;
        sum += kQuadratic * reference_airlight(lamp_ahead(depth), {.fog = {FogMode::exp, part}, .phase = flattened},
                                               ray_beside(angle, 9.2));
      }
      EXPECT_NEAR(octave_glow(phase, depth, angle, 20'000) / sum, 1, 1e-4) << depth << " " << angle;
    }
  }
}

}  // namespace
}  // namespace litfog::bench
