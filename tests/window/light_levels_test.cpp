// SPDX-License-Identifier: Apache-2.0
#include "window/light_levels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace litfog::test {
using namespace window;

namespace {

// White, an eighth of it, none, and what is no light.
const render::Picture kLight{4, 1, {1, 1, 1, 0.125f, 0.125f, 0.125f, 0, 0, 0, NAN, NAN, NAN}};

TEST(LightLevels, WhiteIsLevel0AndTheExposureShiftsAll) {
  EXPECT_NEAR(light_level(&kLight.rgb[0], 0), 0, 1e-6);
  EXPECT_NEAR(light_level(&kLight.rgb[3], 1.5), -1.5, 1e-6);
}

TEST(LightLevels, HistogramCountsEveryPixelOnce) {
  const auto fractions = light_histogram(kLight, 0);
  EXPECT_NEAR(std::reduce(fractions.begin(), fractions.end()), 1, 1e-6);
  EXPECT_EQ(fractions[0], 0.5f);
  EXPECT_EQ(fractions[36], 0.25f);  // -3 of -12 to 4, in quarters
  EXPECT_EQ(fractions[48], 0.25f);
}

TEST(LightLevels, BrighterLightHasABrighterColor) {
  const auto pixels = false_colors(kLight, 0);
  const auto sum = [&](std::size_t i) { return pixels[3 * i] + pixels[3 * i + 1] + pixels[3 * i + 2]; };
  ASSERT_EQ(pixels.size(), 12u);
  EXPECT_GT(sum(0), sum(1));
  EXPECT_GT(sum(1), sum(2));
  EXPECT_EQ(sum(2), 0);
  EXPECT_EQ(sum(3), 0);
}

}  // namespace

}  // namespace litfog::test
