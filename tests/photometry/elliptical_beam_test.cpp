// SPDX-License-Identifier: Apache-2.0
#include "litfog/photometry/elliptical_beam.h"

#include <gtest/gtest.h>

#include <array>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "reference/degree.h"
#include "reference/random_light.h"
#include "reference/ulp.h"

namespace litfog::test {
namespace {

using std::numbers::pi;
using Quadrature = boost::math::quadrature::gauss_kronrod<double, 31>;

/// Approach side row light, EASA CS ADR-DSN.U.940, figure U-6: main beam, 10 % and 5 %.
const std::vector<IsocandelaEllipse> kSideRow{
    {5000, 7 * kDegree, 5 * kDegree}, {500, 11.5 * kDegree, 6 * kDegree}, {250, 16.5 * kDegree, 8 * kDegree}};

/// Solid angle of an ellipse, by integration in polar angles from the edge's definition.
double solid_angle(double horizontal, double vertical) {
  const auto height = [&](double turn) {
    const double across = std::cos(turn) / horizontal, up = std::sin(turn) / vertical;
    return 1 - std::cos(1 / std::sqrt(across * across + up * up));
  };
  return 4 * Quadrature::integrate(height, 0, pi / 2, 15, 1e-13);
}

TEST(EllipticalBeam, CircleOfEqualSolidAngleIsExact) {
  WorstError error("angle", "ellipses", kEqualCircleMaxError, "rad");
  for (const double horizontal : {0.1, 1.0, 10.0, 60.0, 120.0}) {
    for (const double ratio : {1.0, 1.5, 4.0, 20.0}) {
      const double vertical = horizontal / ratio;
      const double circle = equal_circle(horizontal * kDegree, vertical * kDegree);
      const double expected = std::acos(1 - solid_angle(horizontal * kDegree, vertical * kDegree) / (2 * pi));
      error.add(std::abs(circle - expected), [&] { return std::to_string(horizontal) + "/" + std::to_string(ratio); });
    }
  }
  error.check();
}

TEST(EllipticalBeam, CircleOfACircleIsItself) {
  for (const double angle : {1e-6, 0.1, 1.0, 3.0, pi - 1e-3, pi - 1e-5, pi - 1e-7, pi})
    EXPECT_NEAR(equal_circle(angle, angle), angle, 1e-14) << angle;
  EXPECT_NEAR(equal_circle(1e-3, 4e-3), 2e-3, 1e-8);
}

TEST(EllipticalBeam, IntensityIsThatOfTheLines) {
  WorstError error("intensity / peak", "side row light", kEllipticalBeamMaxError, "");
  for (const double squeeze : {1.0, 0.5}) {  // ratios of half axes up to 2 and 4
    auto lines = kSideRow;
    for (IsocandelaEllipse& line : lines) line.vertical *= squeeze;
    const IntensityDistribution beam = elliptical_beam(lines);
    EXPECT_FALSE(find_error(beam));
    for (int i = 0; i < 360; ++i) {
      const double turn = i * kDegree;
      const auto edge = [&](double a, double b) {
        return 1 / std::hypot(std::cos(turn) / a, std::sin(turn) / (b * squeeze));
      };
      const double main = edge(7, 5), tenth = edge(11.5, 6), end = edge(16.5, 8);
      const auto at = [&](double angle_deg) {
        return intensity_at(beam, direction_of(PhotometryType::c, turn, angle_deg * kDegree));
      };
      const auto add = [&](double angle_deg, double intensity) {
        error.add(std::abs(at(angle_deg) - intensity) / 5000, [&] { return std::to_string(i); });
      };
      add(0, 5000);
      add(0.9 * main, 5000);
      add((main + tenth) / 2, 2750);
      add(tenth, 500);
      add((tenth + end) / 2, 375);
      EXPECT_EQ(at(end * 1.05), 0) << i;
    }
  }
  error.check();
}

/// By integration along each half plane, from line to line.
double flux_of(const std::vector<IsocandelaEllipse>& lines) {
  const auto half_plane = [&](double turn) {
    double flux = 0, inner_edge = 0, inner = lines.front().intensity;
    for (const IsocandelaEllipse& line : lines) {
      const double edge = 1 / std::hypot(std::cos(turn) / line.horizontal, std::sin(turn) / line.vertical);
      const auto ring = [&](double t) {
        return std::lerp(inner, line.intensity, t) * std::sin(std::lerp(inner_edge, edge, t)) * (edge - inner_edge);
      };
      flux += Quadrature::integrate(ring, 0, 1, 3, 1e-10);
      inner_edge = edge;
      inner = line.intensity;
    }
    return flux;
  };
  return 4 * Quadrature::integrate(half_plane, 0, pi / 2, 5, 1e-8);
}

TEST(EllipticalBeam, FluxIsTheIntegralOverTheLines) {
  WorstError error("flux", "beams", kSmoothEllipticalFluxMaxError, "");
  for (const double ratio : {1.0, 2.0, 4.0}) {
    for (const double width : {0.2, 7.0, 80.0}) {
      const double a = width * kDegree, b = a / ratio;
      const std::vector<IsocandelaEllipse> lines{{1000, a, b}, {100, 1.5 * a, 1.8 * b}};
      error.add(std::abs(luminous_flux(elliptical_beam(lines)) / flux_of(lines) - 1),
                [&] { return std::to_string(width) + "/" + std::to_string(ratio); });
    }
  }
  const std::vector<IsocandelaEllipse> worst{
      {1000, 0.1024, 0.0273}, {228.5, 0.2531, 0.0674}, {129.8, 0.4431, 0.1108}, {57.1, 0.9054, 0.2957}};
  error.add(std::abs(luminous_flux(elliptical_beam(worst)) / flux_of(worst) - 1), [] { return "found by a climb"; });
  error.check();
}

TEST(EllipticalBeam, FluxOfBeamsWithStepsHasItsStatedError) {
  Random random(31);
  WorstError error("flux", "beams of 1 to 4 lines", kEllipticalFluxMaxError, "");
  for (int i = 0; i < 150; ++i) {
    std::vector<IsocandelaEllipse> lines;
    const double ratio = random.pick(std::array{1.0, 1.0, 2.0, 4.0});
    double width = random.log_uniform(4e-6, 1), intensity = 1000;
    for (int k = int(random.uniform(1, 5)); k > 0; --k) {
      lines.push_back({intensity, width, width / ratio});
      intensity *= random.pick(std::array{1.0, 0.5, random.uniform(0, 1), 0.0});
      width *= 1 + random.log_uniform(1e-6, 100);
    }
    if (find_error(lines)) continue;  // wider than pi
    const IntensityDistribution beam = elliptical_beam(lines);
    ASSERT_FALSE(find_error(beam));
    error.add(std::abs(luminous_flux(beam) / flux_of(lines) - 1), [&] {
      return std::to_string(width) + "/" + std::to_string(ratio) + ", " + std::to_string(lines.size()) + " lines";
    });
  }
  error.check();
}

TEST(EllipticalBeam, WrongLinesAreRefused) {
  const auto rule_of = [](const std::vector<IsocandelaEllipse>& lines) {
    const auto error = find_error(lines);
    return error ? to_string(*error) : "(accepted)";
  };
  EXPECT_EQ(rule_of({}), "ellipses = 0: must be at least one");
  EXPECT_EQ(rule_of({{0, 1, 1}}), "intensity = 0: must be > 0 in the first ellipse");
  EXPECT_EQ(rule_of({{1, 1, 1}, {2, 2, 2}}),
            "intensity = 2: must be in [0, 1e30] and at most that of the ellipse within");
  EXPECT_EQ(rule_of({{1, 0, 1}}),
            "horizontal = 0: must be in [1e-100, pi] and greater than that of the ellipse within");
  EXPECT_EQ(rule_of({{1, 1, 2}, {1, 2, 2}}),
            "vertical = 2: must be in [1e-100, pi] and greater than that of the ellipse within");
  EXPECT_EQ(rule_of(kSideRow), "(accepted)");
  EXPECT_THROW(elliptical_beam({}), std::invalid_argument);
}

}  // namespace
}  // namespace litfog::test
