// SPDX-License-Identifier: Apache-2.0
#include "litfog/light.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace litfog::test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// The refusal of a light that differs from the accepted default by one change.
template <typename Change>
std::string refusal_after(const Change& change) {
  Light light;
  change(light);
  const auto refusal = check(light);
  return refusal ? to_string(*refusal) : "accepted";
}

TEST(Light, OfDefaultsIsAccepted) { EXPECT_FALSE(check(Light{})); }

TEST(Light, RefusesColorsThatAreNoLight) {
  EXPECT_EQ(refusal_after([](Light& l) { l.color.r = -1; }), "color.r = -1: must be finite and >= 0");
  EXPECT_EQ(refusal_after([](Light& l) { l.color.g = kNan; }), "color.g = nan: must be finite and >= 0");
  EXPECT_EQ(refusal_after([](Light& l) { l.color.b = kInfinity; }), "color.b = inf: must be finite and >= 0");
}

TEST(Light, AcceptsBlackAndOverbrightColors) {
  EXPECT_EQ(refusal_after([](Light& l) { l.color = {0, 0, 0}; }), "accepted");
  EXPECT_EQ(refusal_after([](Light& l) { l.color = {1e6, 1, 0}; }), "accepted");
}

TEST(Light, RefusesNegativeOrInfiniteDensityScales) {
  EXPECT_EQ(refusal_after([](Light& l) { l.density_scale = -0.4; }), "density_scale = -0.4: must be finite and >= 0");
  EXPECT_EQ(refusal_after([](Light& l) { l.density_scale = kInfinity; }),
            "density_scale = inf: must be finite and >= 0");
  EXPECT_EQ(refusal_after([](Light& l) { l.density_scale = kNan; }), "density_scale = nan: must be finite and >= 0");
  EXPECT_EQ(refusal_after([](Light& l) { l.density_scale = 0; }), "accepted");
}

TEST(Light, RefusesWhatItsPartsRefuse) {
  EXPECT_EQ(refusal_after([](Light& l) {
              l.attenuation = {0, 0, 0};
            }),
            "attenuation.constant = 0: must be > 0 where linear and quadratic are 0");
  EXPECT_EQ(refusal_after([](Light& l) { l.threshold = 1; }), "threshold = 1: must be in (0, 1)");
  EXPECT_EQ(refusal_after([](Light& l) { l.cone = Cone::cosine(3, 1); }), "cone.half_angle = 3: must be in (0, pi/2]");
  EXPECT_EQ(refusal_after([](Light& l) { l.cone = Cone::smoothstep(1, 0.5); }),
            "cone.inner = 1: must be in [0, outer)");
}

}  // namespace
}  // namespace litfog::test
