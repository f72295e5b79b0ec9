// SPDX-License-Identifier: Apache-2.0
#include "measure/radial_scattering.h"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>

#include "measure/inverse_square_lamp.h"
#include "litfog/airlight.h"
#include "measure/scattering_walk.h"

namespace litfog::test {
namespace {

using measure::RadialScattering;
using std::numbers::pi;

struct Case {
  const char* name;
  Phase phase;
};
const Case kCases[] = {{"isotropic", {}},
                       {"forward", Phase::henyey_greenstein(0.85)},
                       {"droplets of 10", Phase::droplets(10)},
                       {"droplets of 50", Phase::droplets(50)}};

const RadialScattering& nodes() {
  static const RadialScattering result(0.6);
  return result;
}

/// The integral over all directions of all scattered light times a power of the cosine.
double gathered(const RadialScattering::Glow& glow, const Phase& phase, double depth, int power) {
  const Atmosphere air{.fog = {FogMode::exp, 1}, .phase = phase};
  double sum = 0;
  constexpr int kPanels = 4;
  for (int i = 0; i < kPanels; ++i) {
    sum += boost::math::quadrature::gauss<double, 15>::integrate(
        [&](double x) {
          const double angle = pi * std::pow(x, 5);
          const double light =
              kQuadratic * reference_airlight(lamp_ahead(depth), air, ray_beside(angle)) + glow.at(depth, angle);
          return light * 2 * pi * std::sin(angle) * std::pow(std::cos(angle), power) * 5 * pi * std::pow(x, 4);
        },
        double(i) / kPanels, double(i + 1) / kPanels);
  }
  return sum;
}

TEST(RadialScattering, FluxThroughASphereIsThePowerOfTheLamp) {
  for (const Case& c : kCases) {
    const auto glow = nodes().solve(c.phase);
    for (const double depth : {0.3, 3.0}) {
      // Intensity 1, power 4 pi; the unit is that of E / (4 pi).
      const double flux = depth * depth * gathered(glow, c.phase, depth, 1) / (4 * pi) + std::exp(-depth);
      EXPECT_NEAR(flux, 1, 0.01) << c.name << " at " << depth;
    }
  }
}

TEST(RadialScattering, IsotropicFluenceIsTheExactOne) {
  const auto glow = nodes().solve({});
  // exact_fluence(1, depth) of scattering_walk_test.cpp
  for (const auto& [depth, exact] : {std::pair{0.5, 4.0263063}, {2.0, 3.0444473}, {6.0, 3.000198}}) {
    const double fluence = depth * gathered(glow, {}, depth, 0) / (4 * pi) + std::exp(-depth) / depth;
    EXPECT_NEAR(fluence / exact, 1, 0.002) << depth;
  }
}

TEST(RadialScattering, AgreesWithTheRandomWalk) {
  for (const Case& c : kCases) {
    const auto glow = nodes().solve(c.phase);
    for (const auto& [depth, degrees] : {std::pair{0.02, 10.0}, {0.3, 0.5}, {1.0, 3.0}, {1.0, 40.0}, {3.0, 5.0}}) {
      const double angle = degrees * pi / 180;
      measure::ScatteringWalk walk;
      walk.paths = 2048;
      const auto chance =
          walk_scattering(lamp_ahead(depth), {.fog = {FogMode::exp, 1}, .phase = c.phase}, ray_beside(angle), walk)
              .higher;
      const double truth = glow.at(depth, angle), error = kQuadratic * chance.error;
      EXPECT_NEAR(kQuadratic * chance.value, truth, 4 * error + 0.01 * truth)
          << c.name << ", " << depth << ", " << degrees;
    }
  }
}

}  // namespace
}  // namespace litfog::test
