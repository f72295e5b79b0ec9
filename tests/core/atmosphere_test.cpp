// SPDX-License-Identifier: Apache-2.0
#include "litfog/atmosphere.h"

#include <gtest/gtest.h>

#include <array>

#include "reference/double_limits.h"
#include "reference/random_light.h"

namespace litfog::test {
namespace {

Atmosphere layered(double haze = 0.001) {
  const std::array<DensityKnot, 3> knots{{{0, 0.02}, {100, 0.03}, {120, 0}}};
  return {.fog = {FogMode::exp, haze}, .top = 200, .profile = make_density_profile(knots)};
}

TEST(Atmosphere, DensityIsTheFogsPlusTheProfiles) {
  const Atmosphere air = layered();
  EXPECT_DOUBLE_EQ(air.fog_at(50).density, 0.001 + 0.025);
  EXPECT_EQ(air.fog_at(500), air.fog);
  EXPECT_EQ(air.fog_between(30, 30), air.fog_at(30));
  EXPECT_DOUBLE_EQ(air.fog_between(120, 100).density, 0.001 + 0.015);
  EXPECT_EQ(air.thinnest_fog(), air.fog);
  EXPECT_DOUBLE_EQ(air.thickest_fog().density, 0.031);
  EXPECT_EQ(layered(kInfinity).fog_between(0, 300).density, kInfinity);
}

TEST(Atmosphere, DepthOfAPathIsThatOfItsParts) {
  const Atmosphere air = layered();
  Random random(421);
  for (int i = 0; i < 1000; ++i) {
    const double low = random.uniform(-50, 300), high = random.uniform(-50, 300), length = random.uniform(300, 1000);
    const double part = random.uniform(0, 1), middle = low + part * (high - low);
    EXPECT_NEAR(air.fog_between(low, high).density * length,
                air.fog_between(low, middle).density * part * length +
                    air.fog_between(middle, high).density * (1 - part) * length,
                1e-12);
  }
}

TEST(Atmosphere, UniformFogIsTheSameBetweenAllHeights) {
  for (const FogMode mode : kModes) {
    const Atmosphere air{.fog = {mode, 0.1}};
    for (const Fog& fog : {air.fog_at(7), air.fog_between(-3, 1e6), air.thinnest_fog(), air.thickest_fog()}) {
      EXPECT_EQ(fog, air.fog);
    }
  }
}

TEST(Atmosphere, RaysLeaveAndLightEntersAtTheTopOrTheLastKnotAboveIt) {
  EXPECT_EQ(Atmosphere{.top = 60}.top_above(50), 10);
  EXPECT_EQ(Atmosphere{.top = 60}.light_top(), 60);
  EXPECT_EQ(Atmosphere{}.top_above(50), kInfinity);
  EXPECT_EQ(Atmosphere{}.light_top(), kHazeHeight);
  const std::array<DensityKnot, 2> ground{{{100, 0.1}, {120, 0}}}, cloud{{{100, 0}, {120, 0.1}}};
  Atmosphere air{.top = 200, .profile = make_density_profile(ground)};
  EXPECT_EQ(air.top_above(50), 150);
  EXPECT_EQ(air.light_top(), 200);
  air.top = 110;
  EXPECT_EQ(air.top_above(50), 70);
  EXPECT_EQ(air.light_top(), 120);
  air.profile = make_density_profile(cloud);
  EXPECT_EQ(air.top_above(50), kInfinity);
  EXPECT_EQ(air.light_top(), 120 + kHazeHeight);
}

TEST(Atmosphere, AirSeenFromAnotherOriginIsTheSame) {
  const Atmosphere air = layered(), moved = air.seen_from(1024);
  EXPECT_EQ(moved.top, air.top - 1024);
  for (const double height : {-10.0, 0.0, 60.0, 110.0, 500.0})
    EXPECT_EQ(moved.fog_at(height - 1024), air.fog_at(height));
}

TEST(Atmosphere, WrongProfileIsAnError) {
  Atmosphere air = layered();
  EXPECT_FALSE(find_error(air));
  air.fog.mode = FogMode::exp2;
  EXPECT_EQ(to_string(*find_error(air)), "profile.count = 3: must be 0 in exp2 fog");
  air = layered();
  air.profile.knots[1].density = -1;
  EXPECT_EQ(to_string(*find_error(air)), "profile.knots[1].density = -1: must be in [0, 1e300]");
}

}  // namespace
}  // namespace litfog::test
