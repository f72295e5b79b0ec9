// SPDX-License-Identifier: Apache-2.0
#include "litfog/photometry/intensity_distribution.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include "core/value_errors.h"
#include "reference/random_light.h"

namespace litfog::test {
namespace {

using std::numbers::pi;
using Angles = std::vector<double>;

constexpr double kDegree = pi / 180;

Angles degrees(double first, double last, double step) {
  Angles angles;
  const int count = int(std::lround((last - first) / step));
  for (int i = 0; i <= count; ++i) angles.push_back((first + (last - first) * i / count) * kDegree);
  return angles;
}

/// A distribution that holds a function of its two angles.
IntensityDistribution sampled(PhotometryType type, const Angles& horizontal, const Angles& vertical,
                              const std::function<double(double, double)>& intensity) {
  IntensityDistribution distribution{type, horizontal, vertical, {}};
  for (const double h : horizontal) {
    for (const double v : vertical) distribution.intensity.push_back(intensity(h, v));
  }
  return distribution;
}

/// The direction of two angles by rotations of the axis, as the goniophotometer turns: the header's formulas otherwise.
glm::dvec3 turned(PhotometryType type, double horizontal, double vertical) {
  const auto up = [](glm::dvec3 d, double a) {  // about the horizontal axis x
    return glm::dvec3{d.x, d.y * std::cos(a) - d.z * std::sin(a), d.y * std::sin(a) + d.z * std::cos(a)};
  };
  const auto right = [](glm::dvec3 d, double a) {  // about the vertical axis y, clockwise from above
    return glm::dvec3{d.x * std::cos(a) - d.z * std::sin(a), d.y, d.x * std::sin(a) + d.z * std::cos(a)};
  };
  const auto round = [](glm::dvec3 d, double a) {  // about the photometric axis, counterclockwise from behind the light
    return glm::dvec3{d.x * std::cos(a) - d.y * std::sin(a), d.x * std::sin(a) + d.y * std::cos(a), d.z};
  };
  switch (type) {
    case PhotometryType::a:
      return right(up({0, 0, -1}, vertical), horizontal);
    case PhotometryType::b:
      return up(right({0, 0, -1}, horizontal), vertical);
    case PhotometryType::c:
      break;
  }
  return round(right({0, 0, -1}, vertical), horizontal);
}

Angles random_angles(Random& random, double low, double high) {
  Angles angles{low, high};
  for (int i = 0; i < 6; ++i) angles.push_back(random.uniform(low, high));
  std::ranges::sort(angles);
  return angles;
}

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

// --- profiles ---

TEST(AxialProfile, SymmetricBeamHasItsMeasuredProfile) {
  const auto lamp =
      sampled(PhotometryType::c, {0}, {0, 0.1, 0.3, 1.2, 2.3, pi}, [](double, double g) { return 10 - 3 * g; });
  const auto profile = axial_profile(lamp, kPhotometricAxis);
  ASSERT_EQ(profile.size(), lamp.vertical.size());
  for (std::size_t i = 0; i < profile.size(); ++i) {
    EXPECT_EQ(profile[i].angle, lamp.vertical[i]);
    EXPECT_NEAR(profile[i].mean, lamp.intensity[i], 1e-12);
    EXPECT_NEAR(profile[i].deviation, 0, 1e-12);
  }
  const auto from_above = axial_profile(lamp, -kPhotometricAxis);
  ASSERT_EQ(from_above.size(), profile.size());
  for (std::size_t i = 0; i < profile.size(); ++i) {
    const std::size_t mirrored = profile.size() - 1 - i;
    EXPECT_NEAR(from_above[i].angle, pi - lamp.vertical[mirrored], 1e-15);
    EXPECT_NEAR(from_above[i].mean, lamp.intensity[mirrored], 1e-12);
  }
}

TEST(AxialProfile, PlanesAreAveragedOnTheAxisWhereTheyDisagree) {
  const IntensityDistribution lamp{
      PhotometryType::c, degrees(0, 180, 90), degrees(0, 180, 90), {100, 50, 0, 80, 40, 0, 120, 60, 0}};
  EXPECT_NEAR(intensity_at(lamp, kPhotometricAxis), 95, 1e-12);  // (100 / 2 + 80 + 120 / 2) / 2
  EXPECT_NEAR(axial_profile(lamp, kPhotometricAxis)[0].mean, 95, 1e-9);
  EXPECT_NEAR(axial_profile(lamp, -kPhotometricAxis).back().mean, 95, 1e-9);
  EXPECT_NEAR(axial_profile(lamp, kPhotometricAxis)[1].mean, 47.5, 1e-9) << "the same turn beside the axis";
}

TEST(AxialProfile, AnglesThatWereNotMeasuredAreDark) {
  const auto profile_of = [](const std::vector<double>& angles) {
    return axial_profile(sampled(PhotometryType::c, {0}, angles, [](double, double) { return 7; }), kPhotometricAxis);
  };
  const auto expect_profile = [](const std::vector<AxialSample>& profile,
                                 const std::vector<std::pair<double, double>>& expected) {
    ASSERT_EQ(profile.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_NEAR(profile[i].angle / kDegree, expected[i].first, 1e-9) << i;
      EXPECT_NEAR(profile[i].mean, expected[i].second, 1e-12) << i;
    }
  };
  expect_profile(profile_of(degrees(0, 90, 30)),
                 {{0, 7}, {30, 7}, {60, 7}, {90, 7}, {90.01, 0}, {120, 0}, {150, 0}, {180, 0}});
  expect_profile(profile_of(degrees(90, 180, 45)), {{0, 0}, {45, 0}, {89.99, 0}, {90, 7}, {135, 7}, {180, 7}});
  expect_profile(profile_of(degrees(100, 130, 15)), {{0, 0},
                                                     {10, 0},
                                                     {25, 0},
                                                     {40, 0},
                                                     {55, 0},
                                                     {70, 0},
                                                     {85, 0},
                                                     {99.99, 0},
                                                     {100, 7},
                                                     {115, 7},
                                                     {130, 7},
                                                     {130.01, 0},
                                                     {145, 0},
                                                     {160, 0},
                                                     {180, 0}});
}

TEST(AxialProfile, FileThatEndsInTheDarkHasTheProfileOfOneThatGoesOn) {
  const auto beam = [](double, double g) { return std::max(0.0, 100 - 150 * g); };
  const auto short_file = axial_profile(sampled(PhotometryType::c, {0}, degrees(0, 60, 5), beam), kPhotometricAxis);
  const auto whole_file = axial_profile(sampled(PhotometryType::c, {0}, degrees(0, 180, 5), beam), kPhotometricAxis);
  ASSERT_EQ(short_file.size(), whole_file.size());
  for (std::size_t i = 0; i < whole_file.size(); ++i) {
    EXPECT_NEAR(short_file[i].angle, whole_file[i].angle, 1e-12);
    EXPECT_NEAR(short_file[i].mean, whole_file[i].mean, 1e-12);
  }
}

TEST(AxialProfile, ProfileIsTheMeanOverTheTurnWithTheLargestDeviation) {
  const IntensityDistribution lamp{
      PhotometryType::c, degrees(0, 90, 45), degrees(0, 60, 30), {1000, 800, 400, 1000, 600, 100, 1000, 700, 0}};
  const auto profile = axial_profile(lamp, kPhotometricAxis);
  ASSERT_EQ(profile.size(), 8u);  // and dark from 60.01 degrees on
  EXPECT_NEAR(profile[0].mean, 1000, 1e-9);
  EXPECT_NEAR(profile[1].mean, 675, 1e-9);  // (800 / 2 + 600 + 700 / 2) / 2
  EXPECT_NEAR(profile[1].deviation, 125, 1e-9);
  EXPECT_NEAR(profile[2].mean, 150, 1e-9);
  EXPECT_NEAR(profile[2].deviation, 250, 1e-9);
  const auto plane = plane_profile(lamp, pi / 2);
  ASSERT_EQ(plane.size(), profile.size());
  EXPECT_NEAR(plane[1].mean, 700, 1e-9);
}

TEST(AxialProfile, PlaneOfATurnIsTheMeasuredOne) {
  const IntensityDistribution lamp{PhotometryType::c,
                                   degrees(0, 360, 90),
                                   degrees(0, 60, 30),
                                   {1000, 900, 5, 1000, 700, 5, 1000, 500, 5, 1000, 300, 5, 1000, 900, 5}};
  for (const auto& [turn, intensity] : {std::pair{0.0, 900.0}, {pi / 2, 700}, {pi, 500}, {3 * pi / 2, 300}}) {
    EXPECT_NEAR(plane_profile(lamp, turn)[1].mean, intensity, 1e-9) << turn;
  }
}

TEST(AxialProfile, ProfileAboutAnyAxisFollowsABeamAimedThere) {
  const glm::dvec3 aim = turned(PhotometryType::a, 20 * kDegree, -10 * kDegree);
  const auto beam = sampled(PhotometryType::a, degrees(-90, 90, 1), degrees(-90, 90, 1), [&](double h, double v) {
    return 5000 * std::pow(std::max(0.0, glm::dot(aim, turned(PhotometryType::a, h, v))), 30);
  });
  const auto peak = find_peak(beam);
  EXPECT_NEAR(glm::dot(peak.direction, aim), 1, 1e-12);
  const double half = std::acos(std::pow(0.5, 1 / 30.0));
  EXPECT_NEAR(half_angle(axial_profile(beam, aim), 0.5), half, 0.1 * kDegree);
  EXPECT_LT(asymmetry(beam, aim), 0.005);
  EXPECT_GT(asymmetry(beam, kPhotometricAxis), 0.5);
}

/// What axial_profile() has at an angle about an axis other than the grid's, from intensity_at().
AxialSample circle_by_directions(const IntensityDistribution& distribution, const glm::dmat3& frame, double angle) {
  const int stride = 360 / std::max(72, int(std::ceil(360 * std::sin(angle))));
  std::vector<double> values;
  for (int turn = 0; turn < 360; turn += stride) {
    values.push_back(intensity_at(distribution, frame * direction_of(PhotometryType::c, turn * kDegree, angle)));
  }
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
  const auto [least, most] = std::ranges::minmax(values);
  return {angle, mean, std::max(mean - least, most - mean)};
}

TEST(AxialProfile, ProfileAboutAnyAxisMissesNoLitDirection) {
  Random random(31);
  for (int i = 0; i < 60; ++i) {
    const auto type = std::array{PhotometryType::a, PhotometryType::b, PhotometryType::c}[std::size_t(i % 3)];
    const bool is_c = type == PhotometryType::c;
    const double turn_end = random.uniform(0.2, pi), rise_end = random.uniform(0.2, pi / 2);
    const bool is_mirrored = random.uniform(0, 1) < 0.5;
    const auto angles = [&](double most) {
      return random_angles(random, is_mirrored ? 0 : -most * random.uniform(0, 1), most);
    };
    Angles horizontal =
        is_c ? random_angles(random, 0, 2 * pi) : angles(type == PhotometryType::a ? turn_end : rise_end);
    Angles vertical = is_c ? random_angles(random, 0, pi) : angles(type == PhotometryType::a ? rise_end : turn_end);
    const auto lit = [&](const Angles& all, double angle) { return angle > all[1] && angle < all[5]; };
    const auto distribution = sampled(type, horizontal, vertical, [&](double h, double v) {  // dark towards its ends
      return lit(vertical, v) && lit(horizontal, h) ? random.uniform(1, 100) : 0;
    });
    const double peak = find_peak(distribution).intensity;
    glm::dvec3 axis{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    const int kind = i / 3 % 4;
    if (kind == 1) axis.y = 0;  // directions mirror each other
    if (kind > 1 && !is_c) axis = kind == 2 ? kPhotometricAxis : -kPhotometricAxis;
    const glm::dmat3 frame = luminaire_from_light(axis);
    for (const AxialSample& sample : axial_profile(distribution, axis)) {
      const AxialSample expected = circle_by_directions(distribution, frame, sample.angle);
      ASSERT_NEAR(sample.mean, expected.mean, 1e-6 * peak)
          << "light " << i << " at " << sample.angle / kDegree << " degrees";
    }
  }
}

/// Bright up to the last measured angle and over whole turns, from quadrants, halves and single planes, and in
/// intervals of most uneven width; also so faint and so bright that squares would under- and overflow.
TEST(AxialProfile, CirclesAboutAnyAxisAreThoseOfIntensityAt) {
  const auto smooth = [](double h, double v) { return 3 + std::cos(h) * std::sin(v) + std::sin(2 * v + h); };
  const Angles uneven{0, 0.001, 0.002, 0.003, 0.004, 0.1, 0.2, 0.7, 1.5, 3};
  std::vector<IntensityDistribution> lamps{
      sampled(PhotometryType::a, degrees(-180, 180, 10), degrees(-90, 90, 10), smooth),
      sampled(PhotometryType::b, degrees(-90, 90, 10), degrees(-180, 180, 10), smooth),
      sampled(PhotometryType::a, degrees(0, 180, 10), degrees(0, 90, 10), smooth),
      sampled(PhotometryType::b, degrees(0, 90, 10), degrees(0, 180, 10), smooth),
      sampled(PhotometryType::c, {0.3}, uneven, smooth)};
  for (const auto& [first, last] : {std::pair{0, 90}, {0, 180}, {90, 270}, {-90, 90}, {0, 360}, {-180, 180}}) {
    lamps.push_back(sampled(PhotometryType::c, degrees(first, last, 10), degrees(0, 180, 5), smooth));
  }
  const glm::dvec3 aim = turned(PhotometryType::a, 0.3, 0.2);
  for (std::size_t i = 0; i < lamps.size(); ++i) {
    const double scale = std::array{1.0, 1e-200, 1e29}[i % 3];
    IntensityDistribution scaled = lamps[i];
    for (double& candela : scaled.intensity) candela *= scale;
    for (const glm::dvec3& axis : {aim, glm::dvec3{1, 0, 0}}) {
      const glm::dmat3 frame = luminaire_from_light(axis);
      for (const AxialSample& sample : axial_profile(scaled, axis)) {
        if (std::abs(sample.angle - pi / 2) < 1e-9) continue;  // there turns about a pole of types A and B are chance
        const AxialSample expected = circle_by_directions(lamps[i], frame, sample.angle);
        ASSERT_NEAR(sample.mean / scale, expected.mean, 1e-12) << i << " at " << sample.angle / kDegree;
        ASSERT_NEAR(sample.deviation / scale, expected.deviation, 1e-12) << i << " at " << sample.angle / kDegree;
      }
      EXPECT_NEAR(asymmetry(scaled, axis), asymmetry(lamps[i], axis), 1e-9);
    }
  }
}

TEST(AxialProfile, NarrowBeamIsFollowedInTheStepsOfItsGrid) {
  // A search light's, by tenths of a degree: about axes that are not the grid's own.
  const double sigma = 0.3 * kDegree;
  const auto gaussian = [sigma](double h, double v) { return std::exp(-(h * h + v * v) / (sigma * sigma)); };
  for (const PhotometryType type : {PhotometryType::a, PhotometryType::b}) {
    const auto beam = sampled(type, degrees(-5, 5, 0.1), degrees(-5, 5, 0.1), gaussian);
    const auto profile = axial_profile(beam, kPhotometricAxis);
    EXPECT_NEAR(half_angle(profile, 0.5), sigma * std::sqrt(std::log(2)), 0.01 * kDegree);
    EXPECT_NEAR(half_angle(profile, 0.1), sigma * std::sqrt(std::log(10)), 0.02 * kDegree);
    EXPECT_NEAR(profile.back().angle, pi, 1e-15);
    EXPECT_TRUE(std::ranges::is_sorted(profile, std::less_equal(), &AxialSample::angle));
    EXPECT_LT(asymmetry(beam, kPhotometricAxis), 0.02);
  }
}

TEST(HalfAngle, HalfAngleIsLinearBetweenSamplesBeyondThePeak) {
  const std::vector<AxialSample> profile{{0, 20, 0}, {1, 100, 0}, {2, 60, 0}, {3, 0, 0}, {4, 80, 0}};
  EXPECT_DOUBLE_EQ(half_angle(profile, 0.8), 1.5);
  EXPECT_DOUBLE_EQ(half_angle(profile, 0.3), 2.5);
  EXPECT_DOUBLE_EQ(half_angle({{0, 5, 0}, {1, 4, 0}}, 0.5), 1);
  EXPECT_EQ(error_of([&] { half_angle(profile, 0); }), "fraction = 0: must be in (0, 1]");
  EXPECT_EQ(error_of([] { half_angle({}, 0.5); }), "profile = 0: must have at least one sample");
  EXPECT_EQ(half_angle({{0, 0, 0}, {1, 0, 0}}, 0.5), 1);  // dark all over
}

TEST(HalfAngle, MeansMustBeIntensities) {
  for (const double mean : {-1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(half_angle({{0.1, mean, 0}}, 0.5), std::invalid_argument) << mean;
  }
  EXPECT_EQ(error_of([] { half_angle({{0.1, -1, 0}}, 0.5); }), "profile.mean = -1: must be finite and >= 0");
}

// --- asymmetry ---

TEST(Asymmetry, SymmetricBeamHasNoAsymmetry) {
  const auto lamp = sampled(PhotometryType::c, {0}, degrees(0, 90, 5), [](double, double g) { return std::cos(g); });
  EXPECT_LT(asymmetry(lamp, kPhotometricAxis), 1e-12);
}

/// f(gamma) (1 + a cos 2C) has the mean f and the mean square f^2 (1 + a^2 / 2).
TEST(Asymmetry, AsymmetryIsTheRelativeRmsDistanceFromTheMeanOverTheTurn) {
  for (const double a : {0.01, 0.3, 1.0}) {
    const auto lamp = sampled(PhotometryType::c, degrees(0, 90, 1), degrees(0, 90, 1), [a](double c, double g) {
      return 300 * std::pow(std::cos(g), 3) * (1 + a * std::cos(2 * c));
    });
    const double known = std::sqrt(a * a / 2 / (1 + a * a / 2));
    EXPECT_NEAR(asymmetry(lamp, kPhotometricAxis), known, 0.001);
    EXPECT_NEAR(asymmetry(lamp, {1e-6, 0, -1}), known, 0.001) << "by circles of another axis";
  }
}

TEST(Asymmetry, SearchEndsWhereTheAsymmetryIsAboveTheLimit) {
  const auto lamp = sampled(PhotometryType::c, degrees(0, 180, 10), degrees(0, 180, 5),
                            [](double c, double g) { return 2 + std::cos(c) * std::sin(g); });
  for (const glm::dvec3 axis : {glm::dvec3{1, 0, 0}, glm::dvec3{1, 0, -1}, kPhotometricAxis}) {
    const double whole = asymmetry(lamp, axis);
    EXPECT_EQ(asymmetry(lamp, axis, 1.001 * whole + 1e-9), whole);
    if (whole > 0.01) {
      EXPECT_GT(asymmetry(lamp, axis, 0.5 * whole), 0.5 * whole);
      EXPECT_LT(asymmetry(lamp, axis, 0.5 * whole), whole);
    }
  }
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

TEST(IntensityDistributionCheck, AxisWithoutDirectionIsAnError) {
  const auto lamp = sampled(PhotometryType::c, {0}, {0, 1}, [](double, double) { return 1.0; });
  EXPECT_EQ(error_of([&] { asymmetry(lamp, {0, 0, 0}); }), "axis = 0: must be finite and not 0");
  EXPECT_EQ(error_of([&] {
              axial_profile(lamp, {0, std::numeric_limits<double>::infinity(), 0});
            }),
            "axis = inf: must be finite and not 0");
}

}  // namespace
}  // namespace litfog::test
