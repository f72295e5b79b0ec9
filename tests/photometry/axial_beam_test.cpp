// SPDX-License-Identifier: Apache-2.0
#include "litfog/photometry/axial_beam.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

#include "core/value_errors.h"
#include "reference/random_light.h"
#include "sampled_distribution.h"

namespace litfog::test {
namespace {

using std::numbers::pi;

TEST(AxialProfile, SymmetricBeamHasItsMeasuredProfile) {
  const auto lamp =
      sampled(PhotometryType::c, {0}, {0, 0.1, 0.3, 1.2, 2.3, pi}, [](double, double g) { return 10 - 3 * g; });
  const auto profile = AxialBeam(lamp, kPhotometricAxis).profile();
  ASSERT_EQ(profile.size(), lamp.vertical.size());
  for (std::size_t i = 0; i < profile.size(); ++i) {
    EXPECT_EQ(profile[i].angle, lamp.vertical[i]);
    EXPECT_NEAR(profile[i].mean, lamp.intensity[i], 1e-12);
    EXPECT_NEAR(profile[i].deviation, 0, 1e-12);
  }
  const auto from_above = AxialBeam(lamp, -kPhotometricAxis).profile();
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
  EXPECT_NEAR(AxialBeam(lamp, kPhotometricAxis).profile()[0].mean, 95, 1e-9);
  EXPECT_NEAR(AxialBeam(lamp, -kPhotometricAxis).profile().back().mean, 95, 1e-9);
  EXPECT_NEAR(AxialBeam(lamp, kPhotometricAxis).profile()[1].mean, 47.5, 1e-9) << "the same turn beside the axis";
}

TEST(AxialProfile, AnglesThatWereNotMeasuredAreDark) {
  const auto profile_of = [](const std::vector<double>& angles) {
    const auto lamp = sampled(PhotometryType::c, {0}, angles, [](double, double) { return 7; });
    return AxialBeam(lamp, kPhotometricAxis).profile();
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
  const auto profile_to = [&](double end) {
    const auto lamp = sampled(PhotometryType::c, {0}, degrees(0, end, 5), beam);
    return AxialBeam(lamp, kPhotometricAxis).profile();
  };
  const auto short_file = profile_to(60), whole_file = profile_to(180);
  ASSERT_EQ(short_file.size(), whole_file.size());
  for (std::size_t i = 0; i < whole_file.size(); ++i) {
    EXPECT_NEAR(short_file[i].angle, whole_file[i].angle, 1e-12);
    EXPECT_NEAR(short_file[i].mean, whole_file[i].mean, 1e-12);
  }
}

TEST(AxialProfile, ProfileIsTheMeanOverTheTurnWithTheLargestDeviation) {
  const IntensityDistribution lamp{
      PhotometryType::c, degrees(0, 90, 45), degrees(0, 60, 30), {1000, 800, 400, 1000, 600, 100, 1000, 700, 0}};
  const auto profile = AxialBeam(lamp, kPhotometricAxis).profile();
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
  const glm::dvec3 axis{0.6, 0, -0.8};
  for (const AxialSample& sample : plane_profile(lamp, 1, axis)) {
    const glm::dvec3 direction = luminaire_from_light(axis) * direction_of(PhotometryType::c, 1, sample.angle);
    EXPECT_EQ(sample.mean, intensity_at(lamp, direction)) << sample.angle;
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
  EXPECT_NEAR(half_angle(AxialBeam(beam, aim).profile(), 0.5), half, 0.1 * kDegree);
  EXPECT_LT(AxialBeam(beam, aim).asymmetry(), 0.005);
  EXPECT_GT(AxialBeam(beam, kPhotometricAxis).asymmetry(), 0.5);
}

/// What a profile has at an angle about an axis other than the grid's, from intensity_at().
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
    for (const AxialSample& sample : AxialBeam(distribution, axis).profile()) {
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
      for (const AxialSample& sample : AxialBeam(scaled, axis).profile()) {
        if (std::abs(sample.angle - pi / 2) < 1e-9) continue;  // there turns about a pole of types A and B are chance
        const AxialSample expected = circle_by_directions(lamps[i], frame, sample.angle);
        ASSERT_NEAR(sample.mean / scale, expected.mean, 1e-12) << i << " at " << sample.angle / kDegree;
        ASSERT_NEAR(sample.deviation / scale, expected.deviation, 1e-12) << i << " at " << sample.angle / kDegree;
      }
      EXPECT_NEAR(AxialBeam(scaled, axis).asymmetry(), AxialBeam(lamps[i], axis).asymmetry(), 1e-9);
    }
  }
}

TEST(AxialProfile, NarrowBeamIsFollowedInTheStepsOfItsGrid) {
  // A search light's, by tenths of a degree: about axes that are not the grid's own.
  const double sigma = 0.3 * kDegree;
  const auto gaussian = [sigma](double h, double v) { return std::exp(-(h * h + v * v) / (sigma * sigma)); };
  for (const PhotometryType type : {PhotometryType::a, PhotometryType::b}) {
    const auto beam = sampled(type, degrees(-5, 5, 0.1), degrees(-5, 5, 0.1), gaussian);
    const auto profile = AxialBeam(beam, kPhotometricAxis).profile();
    EXPECT_NEAR(half_angle(profile, 0.5), sigma * std::sqrt(std::log(2)), 0.01 * kDegree);
    EXPECT_NEAR(half_angle(profile, 0.1), sigma * std::sqrt(std::log(10)), 0.02 * kDegree);
    EXPECT_NEAR(profile.back().angle, pi, 1e-15);
    EXPECT_TRUE(std::ranges::is_sorted(profile, std::less_equal(), &AxialSample::angle));
    EXPECT_LT(AxialBeam(beam, kPhotometricAxis).asymmetry(), 0.02);
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

TEST(Asymmetry, SymmetricBeamHasNoAsymmetry) {
  const auto lamp = sampled(PhotometryType::c, {0}, degrees(0, 90, 5), [](double, double g) { return std::cos(g); });
  EXPECT_LT(AxialBeam(lamp, kPhotometricAxis).asymmetry(), 1e-12);
}

/// f(gamma) (1 + a cos 2C) has the mean f and the mean square f^2 (1 + a^2 / 2).
TEST(Asymmetry, AsymmetryIsTheRelativeRmsDistanceFromTheMeanOverTheTurn) {
  for (const double a : {0.01, 0.3, 1.0}) {
    const auto lamp = sampled(PhotometryType::c, degrees(0, 90, 1), degrees(0, 90, 1), [a](double c, double g) {
      return 300 * std::pow(std::cos(g), 3) * (1 + a * std::cos(2 * c));
    });
    const double known = std::sqrt(a * a / 2 / (1 + a * a / 2));
    EXPECT_NEAR(AxialBeam(lamp, kPhotometricAxis).asymmetry(), known, 0.001);
    EXPECT_NEAR(AxialBeam(lamp, {1e-6, 0, -1}).asymmetry(), known, 0.001) << "by circles of another axis";
  }
}

TEST(Asymmetry, SearchEndsWhereTheAsymmetryIsAboveTheLimit) {
  const auto smooth = [](double h, double v) { return 2 + std::cos(h) * std::sin(v); };
  const std::vector<IntensityDistribution> lamps{
      sampled(PhotometryType::a, degrees(-180, 180, 5), degrees(-90, 90, 5), smooth),
      sampled(PhotometryType::b, degrees(-90, 90, 5), degrees(-180, 180, 5), smooth),
      sampled(PhotometryType::a, degrees(0, 180, 5), degrees(0, 90, 5), smooth),  // and mirrored
      sampled(PhotometryType::b, degrees(0, 90, 5), degrees(-180, 180, 5), smooth),
      sampled(PhotometryType::c, degrees(0, 90, 10), degrees(0, 180, 5), smooth),
      sampled(PhotometryType::c, degrees(0, 180, 10), degrees(0, 180, 5), smooth)};
  for (const IntensityDistribution& lamp : lamps) {
    for (const glm::dvec3 axis : {glm::dvec3{0.3, 1, 0}, glm::dvec3{1, 0.2, -1}}) {
      const double whole = AxialBeam(lamp, axis).asymmetry();
      ASSERT_GT(whole, 0.01);
      EXPECT_EQ(AxialBeam(lamp, axis).asymmetry(1.001 * whole), whole);
      const double part = AxialBeam(lamp, axis).asymmetry(0.5 * whole);
      EXPECT_GT(part, 0.5 * whole);
      EXPECT_LT(part, whole);
      AxialBeam beam(lamp, axis);
      EXPECT_LT(beam.asymmetry(0.5 * whole), whole);
      EXPECT_EQ(beam.asymmetry(), whole) << "after a search that ended early";
      EXPECT_GT(AxialBeam(lamp, axis).asymmetry(0), 0);
    }
  }
}

TEST(Asymmetry, CirclesOfTheSearchAreThoseOfTheProfile) {
  const auto lamp = sampled(PhotometryType::a, degrees(-90, 90, 5), degrees(-90, 90, 5),
                            [](double h, double v) { return 2 + std::cos(h) * std::sin(v); });
  AxialBeam searched(lamp, {0.3, 1, 0}), other(lamp, {0.3, 1, 0});
  const double asymmetry = searched.asymmetry();
  const auto profile = searched.profile(), expected = other.profile();
  ASSERT_EQ(profile.size(), expected.size());
  for (std::size_t i = 0; i < profile.size(); ++i) {
    EXPECT_EQ(profile[i].angle, expected[i].angle);
    EXPECT_EQ(profile[i].mean, expected[i].mean);
    EXPECT_EQ(profile[i].deviation, expected[i].deviation);
  }
  EXPECT_EQ(other.asymmetry(), asymmetry);
}

/// Of the intensity as interpolated, by Gauss's rule in each part that is smooth, from intensity_at(). An interval of
/// 60 degrees and uneven ones, of quadrants, halves, and whole turns.
TEST(Asymmetry, AsymmetryAboutTheGridsOwnAxisIsThatOfTheIntensityAsInterpolated) {
  using Gauss = boost::math::quadrature::gauss<double, 10>;
  Random random(52);
  for (const auto& [first, last] : {std::pair{0, 90}, {90, 270}, {0, 360}}) {
    Angles vertical = random_angles(random, 0.1, 1.9);
    vertical.push_back(vertical.back() + 60 * kDegree);
    const auto lamp = sampled(PhotometryType::c, degrees(first, last, 30), vertical,
                              [&](double, double) { return random.uniform(0, 100); });
    double squares = 0, deviations = 0;
    for (std::size_t i = 1; i < vertical.size(); ++i) {
      const auto over_turn = [&](double gamma, const auto& value_of) {
        double sum = 0;
        for (int turn = 0; turn < 360; turn += 30) {
          sum += Gauss::integrate(
              [&](double c) { return value_of(intensity_at(lamp, turned(PhotometryType::c, c, gamma))); },
              turn * kDegree, (turn + 30) * kDegree);
        }
        return sum;
      };
      const auto square_of = [&](double gamma, double offset) {
        return std::sin(gamma) * over_turn(gamma, [&](double x) { return (x - offset) * (x - offset); });
      };
      squares += Gauss::integrate([&](double g) { return square_of(g, 0); }, vertical[i - 1], vertical[i]);
      deviations +=
          Gauss::integrate([&](double g) { return square_of(g, over_turn(g, [](double x) { return x; }) / (2 * pi)); },
                           vertical[i - 1], vertical[i]);
    }
    const double expected = std::sqrt(deviations / squares);
    EXPECT_NEAR(AxialBeam(lamp, kPhotometricAxis).asymmetry(), expected, 1e-9) << first << " to " << last;
    EXPECT_NEAR(AxialBeam(lamp, -kPhotometricAxis).asymmetry(), expected, 1e-9) << first << " to " << last;
  }
}

TEST(AxialBeam, MovedBeamHasItsAxis) {
  const auto lamp =
      sampled(PhotometryType::c, {0}, {0, 0.1, 0.3, 1.2, 2.3, pi}, [](double, double g) { return 10 - 3 * g; });
  AxialBeam aimed(lamp, {1, 0, 0});
  const std::vector<AxialSample> expected = aimed.profile();
  AxialBeam moved(std::move(aimed));
  AxialBeam assigned(lamp, kPhotometricAxis);
  assigned = std::move(moved);
  const std::vector<AxialSample> profile = assigned.profile();
  ASSERT_EQ(profile.size(), expected.size());
  for (std::size_t i = 0; i < profile.size(); ++i) EXPECT_EQ(profile[i].mean, expected[i].mean);
}

TEST(AxialBeam, AxisWithoutDirectionIsAnError) {
  const auto lamp = sampled(PhotometryType::c, {0}, {0, 1}, [](double, double) { return 1.0; });
  EXPECT_EQ(error_of([&] { AxialBeam(lamp, {0, 0, 0}); }), "axis = 0: must be finite and not 0");
  EXPECT_EQ(error_of([&] {
              AxialBeam(lamp, {0, std::numeric_limits<double>::infinity(), 0});
            }),
            "axis = inf: must be finite and not 0");
}

}  // namespace
}  // namespace litfog::test
