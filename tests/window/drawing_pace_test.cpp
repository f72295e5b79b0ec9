// SPDX-License-Identifier: Apache-2.0
#include "window/drawing_pace.h"

#include <gtest/gtest.h>

namespace litfog::test {
using namespace window;

namespace {

/// Where a rasteriser ends whose pictures take a fixed time and a time that goes with their pixels, milliseconds.
int settled(double fixed, double whole) {
  DrawingPace pace;
  for (int i = 0; i < 20; ++i) pace.learn(pace.divisor(), fixed + whole / (pace.divisor() * pace.divisor()));
  return pace.divisor();
}

TEST(DrawingPace, FastRasteriserDrawsAtFullSize) { EXPECT_EQ(settled(1, 15), 1); }

TEST(DrawingPace, SlowRasteriserMeetsTheTimeWhereItCan) {
  for (const double whole : {100.0, 300.0, 1000.0, 3000.0}) {
    const int divisor = settled(5, whole);
    EXPECT_LE(5 + whole / (divisor * divisor), 1.1 * DrawingPace::kTarget) << whole;
    EXPECT_GE(5 + whole / ((divisor - 1) * (divisor - 1)), 0.5 * DrawingPace::kTarget) << whole;
  }
}

TEST(DrawingPace, HopelessRasteriserDrawsAtTheCoarsest) { EXPECT_EQ(settled(1000, 20'000), DrawingPace::kCoarsest); }

TEST(DrawingPace, DoesNotWaverWhereTimesVary) {
  DrawingPace pace;
  for (int i = 0; i < 20; ++i) pace.learn(pace.divisor(), 1000.0 / (pace.divisor() * pace.divisor()));
  const int divisor = pace.divisor();
  for (int i = 0; i < 20; ++i) {
    pace.learn(divisor, 1000.0 / (divisor * divisor) * (i % 2 == 0 ? 0.85 : 1.15));
    EXPECT_EQ(pace.divisor(), divisor);
  }
}

}  // namespace

}  // namespace litfog::test
