// SPDX-License-Identifier: Apache-2.0
#include "scene/paint/cookie_pattern.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/glm.hpp>
#include <numbers>

#include "reference/random_light.h"

namespace litfog::test {
using namespace scene;

namespace {

using glm::dvec3;

TEST(CookiePattern, BeaconHasTwoBeamsAcrossItsAxis) {
  const Cookie beacon = paint_cookie("beacon");
  for (const double side : {1.0, -1.0}) {
    EXPECT_NEAR(cookie_at(beacon, {side, 0, 0}), 1, 1e-6);
    EXPECT_EQ(cookie_at(beacon, {0, 0, side}), 0);
    EXPECT_EQ(cookie_at(beacon, {0, side, 0}), 0);
    EXPECT_NEAR(cookie_at(beacon, {side, 0, std::tan(glm::radians(7.0))}), 1, 1e-4);
    EXPECT_EQ(cookie_at(beacon, {side, std::tan(glm::radians(25.0)), 0}), 0);
  }
}

TEST(CookiePattern, MirrorBallHasSpotsAllAround) {
  const Cookie disco = paint_cookie("disco");
  Random random(9);
  int bright = 0;
  int dark = 0;
  constexpr int kRays = 20'000;
  int octants[8] = {};
  for (int i = 0; i < kRays; ++i) {
    dvec3 direction;
    do {
      direction = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    } while (glm::length(direction) > 1);
    const double fraction = cookie_at(disco, direction);
    ASSERT_TRUE(fraction >= 0 && fraction <= 1);
    if (fraction > 0.99) {
      ++bright;
      ++octants[(direction.x > 0) + 2 * (direction.y > 0) + 4 * (direction.z > 0)];
    }
    if (fraction < 0.01) ++dark;
  }
  // Spots of 0.26 ring widths to full brightness and 0.36 to darkness, about one a ring width squared.
  EXPECT_NEAR(double(bright) / kRays, std::numbers::pi * 0.26 * 0.26, 0.04);
  EXPECT_NEAR(double(dark) / kRays, 1 - std::numbers::pi * 0.36 * 0.36, 0.06);
  for (const int octant : octants) EXPECT_GT(octant, bright / 16);
}

}  // namespace
}  // namespace litfog::test
