// SPDX-License-Identifier: Apache-2.0
#include "litfog/photometry/intensity_distribution.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <numbers>
#include <vector>

#include "core/value_errors.h"
#include "reference/digits50.h"
#include "reference/random_light.h"
#include "sampled_distribution.h"

namespace litfog::test {
namespace {

using std::numbers::pi;

// --- where directions lie ---

TEST(IntensityDistribution, AnglesOfADirectionLeadBackToIt) {
  Random random(14);
  for (const auto type : {PhotometryType::a, PhotometryType::b, PhotometryType::c}) {
    for (int i = 0; i < 1000; ++i) {
      const glm::dvec3 direction =
          glm::normalize(glm::dvec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)));
      const auto [horizontal, vertical] = angles_of(type, 3.0 * direction);
      EXPECT_LT(glm::length(direction_of(type, horizontal, vertical) - direction), 1e-14);
    }
  }
}

TEST(IntensityDistribution, AnglesTurnAsTheGoniophotometerOfTheirType) {
  Random random(1);
  for (const PhotometryType type : {PhotometryType::a, PhotometryType::b, PhotometryType::c}) {
    const bool is_c = type == PhotometryType::c;
    const auto horizontal = is_c ? degrees(0, 360, 15) : degrees(-90, 90, 15);
    const auto vertical = is_c ? degrees(0, 180, 15) : degrees(-90, 90, 15);
    // Linear in both angles, so that it tells them apart and is interpolated exactly.
    const auto linear = sampled(type, horizontal, vertical, [](double h, double v) { return 1000 + 10 * h + v; });
    for (int i = 0; i < 2000; ++i) {
      const double h = random.uniform(horizontal.front(), horizontal.back());
      const double v = random.uniform(vertical.front(), vertical.back());
      EXPECT_NEAR(intensity_at(linear, turned(type, h, v)), 1000 + 10 * h + v, 1e-6) << h << " " << v;
    }
  }
}

TEST(IntensityDistribution, AxisIsAheadRightIsPlusXAndUpIsPlusY) {
  const auto peak_of = [](PhotometryType type, double h_deg, double v_deg) {
    const bool is_c = type == PhotometryType::c;
    const auto horizontal = is_c ? degrees(0, 360, 45) : degrees(-90, 90, 45);
    const auto vertical = is_c ? degrees(0, 180, 45) : degrees(-90, 90, 45);
    return find_peak(sampled(type, horizontal, vertical,
                             [&](double h, double v) {
                               return 1 / (1 + std::abs(h - h_deg * kDegree) + std::abs(v - v_deg * kDegree));
                             }))
        .direction;
  };
  const auto near = [](const glm::dvec3& a, const glm::dvec3& b) { return glm::length(a - b) < 1e-12; };
  const double s = std::sqrt(0.5);
  EXPECT_TRUE(near(peak_of(PhotometryType::a, 0, 0), kPhotometricAxis));
  EXPECT_TRUE(near(peak_of(PhotometryType::a, 90, 0), {1, 0, 0}));
  EXPECT_TRUE(near(peak_of(PhotometryType::a, 0, 45), {0, s, -s}));
  EXPECT_TRUE(near(peak_of(PhotometryType::a, 45, 45), {0.5, s, -0.5}));
  EXPECT_TRUE(near(peak_of(PhotometryType::b, 0, 0), kPhotometricAxis));
  EXPECT_TRUE(near(peak_of(PhotometryType::b, 45, 0), {s, 0, -s}));
  EXPECT_TRUE(near(peak_of(PhotometryType::b, 0, 90), {0, 1, 0}));
  EXPECT_TRUE(near(peak_of(PhotometryType::b, 45, 45), {s, 0.5, -0.5}));
  EXPECT_TRUE(near(peak_of(PhotometryType::c, 0, 90), {1, 0, 0}));
  EXPECT_TRUE(near(peak_of(PhotometryType::c, 90, 90), {0, 1, 0}));
  EXPECT_TRUE(near(peak_of(PhotometryType::c, 180, 45), {-s, 0, -s}));
}

TEST(IntensityDistribution, UnmeasuredDirectionsAreDark) {
  const auto one = [](double, double) { return 1.0; };
  const auto c = sampled(PhotometryType::c, {0}, degrees(0, 90, 10), one);
  EXPECT_EQ(intensity_at(c, {1, 2, 0}), 1);
  EXPECT_EQ(intensity_at(c, {1, 2, 1e-6}), 0);
  const auto a = sampled(PhotometryType::a, degrees(-30, 40, 10), degrees(-10, 20, 10), one);
  EXPECT_EQ(intensity_at(a, turned(PhotometryType::a, 40 * kDegree, 20 * kDegree)), 1);
  EXPECT_EQ(intensity_at(a, turned(PhotometryType::a, -31 * kDegree, 0)), 0);
  EXPECT_EQ(intensity_at(a, turned(PhotometryType::a, 0, 21 * kDegree)), 0);
  EXPECT_EQ(intensity_at(a, {0, 0, 1}), 0);
  const auto b = sampled(PhotometryType::b, degrees(-30, 40, 10), degrees(-10, 20, 10), one);
  EXPECT_EQ(intensity_at(b, turned(PhotometryType::b, -30 * kDegree, -10 * kDegree)), 1);
  EXPECT_EQ(intensity_at(b, turned(PhotometryType::b, 41 * kDegree, 0)), 0);
  EXPECT_EQ(intensity_at(b, {0, 0, 1}), 0);
}

// --- symmetry ---

TEST(IntensityDistribution, QuadrantHalfAndWholeAreTheSame) {
  const auto lamp = [](double c, double gamma) {
    return 100 * std::exp(-gamma) * (2 + std::cos(2 * c) + 0.3 * std::cos(4 * c));
  };
  const auto gamma = degrees(0, 120, 10);
  const auto whole = sampled(PhotometryType::c, degrees(0, 360, 15), gamma, lamp);
  const auto half = sampled(PhotometryType::c, degrees(0, 180, 15), gamma, lamp);
  const auto other_half = sampled(PhotometryType::c, degrees(90, 270, 15), gamma, lamp);
  const auto quadrant = sampled(PhotometryType::c, degrees(0, 90, 15), gamma, lamp);
  Random random(2);
  for (int i = 0; i < 5000; ++i) {
    const auto direction = draw_direction(random);
    const double expected = intensity_at(whole, direction);
    for (const auto* part : {&half, &other_half, &quadrant}) {
      EXPECT_NEAR(intensity_at(*part, direction), expected, 1e-12 * 400);
    }
  }
  for (const auto* part : {&half, &other_half, &quadrant}) {
    EXPECT_NEAR(luminous_flux(*part), luminous_flux(whole), 1e-12 * luminous_flux(whole));
  }
}

TEST(IntensityDistribution, HalfIsMirroredAtItsFirstPlane) {
  const auto gamma = degrees(0, 180, 30);
  const auto about_c0 = [](double c, double g) { return 50 + 20 * std::cos(c) * std::sin(g); };   // even in y
  const auto about_c90 = [](double c, double g) { return 50 + 20 * std::sin(c) * std::sin(g); };  // even in x
  const std::vector<std::pair<IntensityDistribution, IntensityDistribution>> pairs{
      {sampled(PhotometryType::c, degrees(0, 180, 30), gamma, about_c0),
       sampled(PhotometryType::c, degrees(0, 360, 30), gamma, about_c0)},
      {sampled(PhotometryType::c, degrees(90, 270, 30), gamma, about_c90),
       sampled(PhotometryType::c, degrees(0, 360, 30), gamma, about_c90)},
      {sampled(PhotometryType::c, degrees(-90, 90, 30), gamma, about_c90),
       sampled(PhotometryType::c, degrees(0, 360, 30), gamma, about_c90)}};
  Random random(3);
  for (const auto& [half, whole] : pairs) {
    for (int i = 0; i < 1000; ++i) {
      const auto direction = draw_direction(random);
      EXPECT_NEAR(intensity_at(half, direction), intensity_at(whole, direction), 1e-10);
    }
  }
}

TEST(IntensityDistribution, TypesAAndBAreMirroredAtTheAxisTheyStartFrom) {
  const auto even = [](double h, double v) { return 10 + std::cos(2 * h) + std::cos(3 * v); };
  Random random(4);
  for (const PhotometryType type : {PhotometryType::a, PhotometryType::b}) {
    const auto whole = sampled(type, degrees(-90, 90, 10), degrees(-90, 90, 10), even);
    const auto quadrant = sampled(type, degrees(0, 90, 10), degrees(0, 90, 10), even);
    const auto half = sampled(type, degrees(0, 90, 10), degrees(-90, 90, 10), even);
    for (int i = 0; i < 1000; ++i) {
      const auto direction = draw_direction(random);
      EXPECT_NEAR(intensity_at(quadrant, direction), intensity_at(whole, direction), 1e-12);
      EXPECT_NEAR(intensity_at(half, direction), intensity_at(whole, direction), 1e-12);
    }
    EXPECT_NEAR(luminous_flux(quadrant), luminous_flux(whole), 1e-12 * luminous_flux(whole));
    EXPECT_NEAR(luminous_flux(half), luminous_flux(whole), 1e-12 * luminous_flux(whole));
  }
}

// --- flux ---

TEST(LuminousFlux, FluxOfLinearIntensitiesIsExact) {
  const auto linear = [](double h, double v) { return (3 + 0.4 * h) * (5 + 0.7 * v); };
  const auto sine_moment = [](double low, double high) {  // integral of (5 + 0.7 v) cos v
    const auto antiderivative = [](double v) { return 5 * std::sin(v) + 0.7 * (v * std::sin(v) + std::cos(v)); };
    return antiderivative(high) - antiderivative(low);
  };
  const auto moment = [](double low, double high) { return 3 * (high - low) + 0.2 * (high * high - low * low); };
  Random random(5);
  for (int i = 0; i < 100; ++i) {
    // Type C is the same with v = gamma - pi / 2: 5 + 0.7 v is not shifted, so shift the integrand.
    const auto c = sampled(PhotometryType::c, random_angles(random, 0, 2 * pi), random_angles(random, 0, pi),
                           [&](double h, double gamma) { return linear(h, gamma - pi / 2); });
    const double expected_c = moment(0, 2 * pi) * sine_moment(-pi / 2, pi / 2);
    EXPECT_NEAR(luminous_flux(c), expected_c, 1e-12 * expected_c);

    const double h0 = random.uniform(-1.5, -0.5), h1 = random.uniform(0.5, 1.5);
    const double v0 = random.uniform(-1.5, -0.5), v1 = random.uniform(0.5, 1.5);
    const auto a = sampled(PhotometryType::a, random_angles(random, h0, h1), random_angles(random, v0, v1), linear);
    const double expected_a = moment(h0, h1) * sine_moment(v0, v1);
    EXPECT_NEAR(luminous_flux(a), expected_a, 1e-12 * expected_a);
    const auto b = sampled(PhotometryType::b, random_angles(random, v0, v1), random_angles(random, h0, h1),
                           [&](double h, double v) { return linear(v, h); });
    EXPECT_NEAR(luminous_flux(b), expected_a, 1e-12 * expected_a);
  }
}

TEST(LuminousFlux, NarrowBeamHasItsStatedDigits) {
  const std::vector<double> intensity{1e6, 9e5, 5e5, 1e5, 0};
  for (const double step : {0.1, 0.03, 1e-3, 1e-5, 1e-7}) {
    IntensityDistribution beam{.type = PhotometryType::c, .horizontal = {0}, .vertical = {}, .intensity = intensity};
    Digits50 expected = 0;
    for (std::size_t i = 0; i < intensity.size(); ++i) {
      beam.vertical.push_back(step * double(i));
      if (i == 0) continue;
      const Digits50 low = beam.vertical[i - 1], high = beam.vertical[i];
      const Digits50 slope = (Digits50(intensity[i]) - Digits50(intensity[i - 1])) / (high - low);
      const auto antiderivative = [&](const Digits50& u) -> Digits50 {  // of the intensity times sin u
        return slope * sin(u) - (Digits50(intensity[i]) + slope * (u - high)) * cos(u);
      };
      expected += 2 * boost::math::constants::pi<Digits50>() * (antiderivative(high) - antiderivative(low));
    }
    EXPECT_LE(relative_error(luminous_flux(beam), double(expected)), 1e-12) << step;
  }
}

TEST(LuminousFlux, FineGridLosesNoDigits) {
  const auto fine = sampled(PhotometryType::c, {0}, degrees(0, 180, 0.02), [](double, double) { return 1.0; });
  EXPECT_NEAR(luminous_flux(fine), 4 * pi, 1e-12 * 4 * pi);
}

TEST(LuminousFlux, FluxIsTheIntegralOfTheIntensityOverDirections) {
  Random random(6);
  using Gauss = boost::math::quadrature::gauss<double, 15>;
  for (const PhotometryType type : {PhotometryType::a, PhotometryType::b, PhotometryType::c}) {
    const bool is_c = type == PhotometryType::c;
    const auto horizontal = is_c ? random_angles(random, 0, 2 * pi) : random_angles(random, -1.4, 1.2);
    const auto vertical = is_c ? random_angles(random, 0, 2.5) : random_angles(random, -1.1, 1.3);
    const auto beam = sampled(type, horizontal, vertical, [&](double, double) { return random.uniform(0, 100); });
    double flux = 0;
    for (std::size_t h = 1; h < horizontal.size(); ++h) {
      for (std::size_t v = 1; v < vertical.size(); ++v) {
        const auto along_h = [&](double x) {
          const auto along_v = [&](double y) {
            const double area = is_c ? std::sin(y) : type == PhotometryType::a ? std::cos(y) : std::cos(x);
            return area * intensity_at(beam, turned(type, x, y));
          };
          return Gauss::integrate(along_v, vertical[v - 1], vertical[v]);
        };
        flux += Gauss::integrate(along_h, horizontal[h - 1], horizontal[h]);
      }
    }
    EXPECT_NEAR(luminous_flux(beam), flux, 1e-10 * flux);
  }
}

/// cos^n of the angle from the axis is cos^n H cos^n V in types A and B. Its second derivative in any angle is at most
/// n, so that linear interpolation with step h errs by at most n h^2 / 8 an angle.
TEST(LuminousFlux, CosinePowerHasTheSameFluxInAllTypes) {
  for (const double n : {1.0, 4.0, 20.0}) {
    const auto beam = [n](double h, double v) { return 1000 * std::pow(std::abs(std::cos(h) * std::cos(v)), n); };
    const double bound = 1000 * 2 * n * kDegree * kDegree / 8;
    const auto a = sampled(PhotometryType::a, degrees(-90, 90, 1), degrees(-90, 90, 1), beam);
    const auto b = sampled(PhotometryType::b, degrees(0, 90, 1), degrees(0, 90, 1), beam);
    const auto c = sampled(PhotometryType::c, {0}, degrees(0, 90, 1), [&](double, double v) { return beam(0, v); });
    for (const auto* each : {&a, &b, &c}) {
      EXPECT_NEAR(luminous_flux(*each), 1000 * 2 * pi / (n + 1), bound * 2 * pi);
      Random random(7);
      for (int i = 0; i < 2000; ++i) {
        const auto direction = draw_direction(random);
        const double expected = direction.z < 0 ? 1000 * std::pow(-direction.z, n) : 0;
        EXPECT_NEAR(intensity_at(*each, direction), expected, bound);
      }
    }
  }
}

// --- the light's frame ---

TEST(LuminaireFromLight, AxisIsMinusZAndThePhotometricAxisLeavesAllInPlace) {
  EXPECT_EQ(luminaire_from_light(kPhotometricAxis), glm::dmat3(1));
  Random random(9);
  std::vector<glm::dvec3> axes{{0, 1, 0}, {0, -2, 0}, {0, 0, 1}, {1, 0, 0}, {1e-200, 0, 1e-200}};
  for (int i = 0; i < 100; ++i) axes.push_back(1e3 * draw_direction(random));
  for (const glm::dvec3& axis : axes) {
    const glm::dmat3 rotation = luminaire_from_light(axis);
    const glm::dvec3 scaled = axis / std::max({std::abs(axis.x), std::abs(axis.y), std::abs(axis.z)});
    EXPECT_NEAR(glm::dot(rotation * glm::dvec3(0, 0, -1), glm::normalize(scaled)), 1, 1e-15);
    EXPECT_NEAR(glm::determinant(rotation), 1, 1e-14);
    EXPECT_NEAR(rotation[0].y, 0, 1e-15) << "+x stays level";
  }
  EXPECT_EQ(error_of([] { luminaire_from_light({0, 0, 0}); }), "axis = 0: must be finite and not 0");
}

// --- checks ---

TEST(IntensityDistributionCheck, ErrorNamesWhatIsWrong) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto error = [](PhotometryType type, Angles horizontal, Angles vertical, Angles intensity) {
    return error_of([&] { luminous_flux({type, std::move(horizontal), std::move(vertical), std::move(intensity)}); });
  };
  constexpr auto kA = PhotometryType::a, kB = PhotometryType::b, kC = PhotometryType::c;
  EXPECT_EQ(error(kC, {0}, {0, 1}, {1, 0}), "no error");
  EXPECT_EQ(error(kC, {}, {0, 1}, {}), "distribution.horizontal = 0: must be at least two angles");
  EXPECT_EQ(error(kC, {0}, {0}, {1}), "distribution.vertical = 1: must be at least two angles");
  EXPECT_EQ(error(kC, {0}, {0, 0}, {1, 1}), "distribution.vertical = 0: must be in increasing order");
  EXPECT_EQ(error(kC, {0}, {0, nan}, {1, 1}),
            "distribution.vertical = nan: must be within the range of its photometry type");
  EXPECT_EQ(error(kC, {0}, {-0.1, 1}, {1, 1}),
            "distribution.vertical = -0.1: must be within the range of its photometry type");
  const auto half = double(float(std::numbers::pi / 2)), whole = double(float(2 * std::numbers::pi));
  EXPECT_EQ(error(kC, {0, half, whole}, {0, 1}, {1, 1, 1, 1, 1, 1}), error(kC, {0}, {0, 1}, {1, 1})) << "floats";
  EXPECT_EQ(error(kC, {0, 1}, {0, 1}, {1, 1, 1, 1}), "distribution.horizontal = 1: must span pi / 2, pi or 2 pi");
  EXPECT_EQ(error(kA, {0}, {0, 1}, {1, 1}), "distribution.horizontal = 1: must be at least two angles");
  EXPECT_EQ(error(kA, {0, 1}, {0, 1.6}, {1, 1, 1, 1}),
            "distribution.vertical = 1.6: must be within the range of its photometry type");
  EXPECT_EQ(error(kB, {0, 1.6}, {0, 1}, {1, 1, 1, 1}),
            "distribution.horizontal = 1.6: must be within the range of its photometry type");
  EXPECT_EQ(error(kB, {0, 1}, {-3, 3}, {1, 1, 1, 1}), "no error");
  EXPECT_EQ(error(kC, {0}, {0, 1}, {1}), "distribution.intensity = 1: must be as many as pairs of angles");
  EXPECT_EQ(error(kC, {0}, {0, 1}, {1, -1}), "distribution.intensity = -1: must be in [0, 1e30]");
  EXPECT_EQ(error(kC, {0}, {0, 1}, {1, nan}), "distribution.intensity = nan: must be in [0, 1e30]");
  EXPECT_EQ(error(kC, {0}, {0, 1}, {0, 0}), "distribution.intensity = 0: must not be 0 everywhere");
}

}  // namespace
}  // namespace litfog::test
