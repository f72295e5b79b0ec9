// SPDX-License-Identifier: Apache-2.0
#include "litfog/cone.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "random_light.h"

namespace litfog::test {
namespace {

using std::numbers::pi;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(Cone, OfAPointLightIsOneEverywhere) {
  for (const double cos_angle : {-1.0, -0.5, 0.0, 0.5, 1.0}) EXPECT_EQ(cone_at(Cone{}, cos_angle), 1);
  EXPECT_EQ(cutoff_angle(Cone{}), pi);
}

TEST(Cone, OfCosineProfileIsAPowerOfTheCosineInsideTheHalfAngle) {
  const Cone cone = Cone::cosine(0.5, 8);
  EXPECT_EQ(cone_at(cone, 1), 1);
  EXPECT_DOUBLE_EQ(cone_at(cone, std::cos(0.3)), std::pow(std::cos(0.3), 8));
  EXPECT_DOUBLE_EQ(cone_at(cone, std::cos(0.4999)), std::pow(std::cos(0.4999), 8));
  EXPECT_EQ(cutoff_angle(cone), 0.5);
}

TEST(Cone, OfCosineProfileIsDarkFromTheHalfAngleOn) {
  const Cone cone = Cone::cosine(0.5, 0);
  EXPECT_EQ(cone_at(cone, std::cos(0.5)), 0);
  EXPECT_EQ(cone_at(cone, std::cos(0.501)), 0);
  EXPECT_EQ(cone_at(cone, 0), 0);
  EXPECT_EQ(cone_at(cone, -1), 0);
}

TEST(Cone, OfExponentZeroIsAFlatBeam) {
  const Cone cone = Cone::cosine(0.5, 0);
  for (const double angle : {0.0, 0.1, 0.4, 0.499}) EXPECT_EQ(cone_at(cone, std::cos(angle)), 1);
}

TEST(Cone, OfSmoothstepProfileIsFullInsideAndDarkOutside) {
  const Cone cone = Cone::smoothstep(0.2, 0.6);
  EXPECT_EQ(cone_at(cone, 1), 1);
  EXPECT_EQ(cone_at(cone, std::cos(0.2)), 1);
  EXPECT_EQ(cone_at(cone, std::cos(0.6)), 0);
  EXPECT_EQ(cone_at(cone, std::cos(0.7)), 0);
  EXPECT_EQ(cone_at(cone, -1), 0);
  EXPECT_EQ(cutoff_angle(cone), 0.6);
}

TEST(Cone, OfSmoothstepProfileIsHermitesCubicBetween) {
  const Cone cone = Cone::smoothstep(0.2, 0.6);
  const double inner = std::cos(0.2);
  const double outer = std::cos(0.6);
  EXPECT_NEAR(cone_at(cone, (inner + outer) / 2), 0.5, 1e-15);
  EXPECT_NEAR(cone_at(cone, outer + 0.25 * (inner - outer)), 0.25 * 0.25 * (3 - 2 * 0.25), 1e-15);
}

TEST(Cone, NeverRisesWithTheAngleAndNeverLeavesItsRange) {
  Random random(5);
  for (int i = 0; i < 1000; ++i) {
    const double outer = random.uniform(1e-3, pi);
    const Cone cone = random.chance(0.5) ? Cone::cosine(random.uniform(1e-3, pi / 2), random.log_uniform(1e-3, 1e3))
                                         : Cone::smoothstep(random.uniform(0, outer * 0.999), outer);
    ASSERT_FALSE(check(cone));
    double last = 1;
    for (int step = 0; step <= 200; ++step) {
      const double share = cone_at(cone, 1 - step / 100.);
      ASSERT_TRUE(share >= 0 && share <= last) << "angle " << std::acos(1 - step / 100.) << ": " << share;
      last = share;
    }
  }
}

TEST(Cone, RefusesAnglesAndExponentsOffTheirRange) {
  const auto refusal = [](const Cone& cone) { return check(cone) ? to_string(*check(cone)) : "accepted"; };
  EXPECT_EQ(refusal(Cone::cosine(0, 1)), "cone.half_angle = 0: must be in (0, pi/2]");
  EXPECT_EQ(refusal(Cone::cosine(2, 1)), "cone.half_angle = 2: must be in (0, pi/2]");
  EXPECT_EQ(refusal(Cone::cosine(kNan, 1)), "cone.half_angle = nan: must be in (0, pi/2]");
  EXPECT_EQ(refusal(Cone::cosine(1, -1)), "cone.exponent = -1: must be finite and >= 0");
  EXPECT_EQ(refusal(Cone::cosine(1, kInfinity)), "cone.exponent = inf: must be finite and >= 0");
  EXPECT_EQ(refusal(Cone::cosine(1, kNan)), "cone.exponent = nan: must be finite and >= 0");
  EXPECT_EQ(refusal(Cone::smoothstep(0, 0)), "cone.outer = 0: must be in (0, pi]");
  EXPECT_EQ(refusal(Cone::smoothstep(0, 4)), "cone.outer = 4: must be in (0, pi]");
  EXPECT_EQ(refusal(Cone::smoothstep(0, kNan)), "cone.outer = nan: must be in (0, pi]");
  EXPECT_EQ(refusal(Cone::smoothstep(0.5, 0.5)), "cone.inner = 0.5: must be in [0, outer)");
  EXPECT_EQ(refusal(Cone::smoothstep(-0.5, 0.5)), "cone.inner = -0.5: must be in [0, outer)");
  EXPECT_EQ(refusal(Cone::smoothstep(kNan, 0.5)), "cone.inner = nan: must be in [0, outer)");
}

TEST(Cone, AcceptsTheEndsOfItsRanges) {
  EXPECT_FALSE(check(Cone{}));
  EXPECT_FALSE(check(Cone::cosine(pi / 2, 0)));
  EXPECT_FALSE(check(Cone::cosine(1e-300, std::numeric_limits<double>::max())));
  EXPECT_FALSE(check(Cone::smoothstep(0, pi)));
}

TEST(Cone, OfAnyAcceptedWidthIsNeverNan) {
  for (const Cone& cone : {Cone::smoothstep(0, 1e-9), Cone::smoothstep(0, 1e-300), Cone::smoothstep(1, 1 + 1e-15),
                           Cone::smoothstep(std::nextafter(pi, 0), pi), Cone::cosine(1e-300, 1e300),
                           Cone::cosine(pi / 2, std::numeric_limits<double>::max())}) {
    ASSERT_FALSE(check(cone));
    for (const double cos_angle : {-1.0, -std::cos(1e-9), 0.0, std::cos(1.0), std::cos(1e-9), 1 - 0x1p-53, 1.0}) {
      const double share = cone_at(cone, cos_angle);
      EXPECT_TRUE(share >= 0 && share <= 1)
          << "inner " << cone.inner << ", outer " << cone.outer << ", cosine " << cos_angle << ": " << share;
    }
  }
}

}  // namespace
}  // namespace litfog::test
