// SPDX-License-Identifier: Apache-2.0
#include "scene/model/road.h"

#include <gtest/gtest.h>

namespace litfog::test {
using namespace scene;

namespace {

TEST(Road, RoadPaintLiesOverTheRoad) {
  const RoadMarkings markings;
  const Bounds paint = bounds(make_road_markings(markings));
  EXPECT_GE(paint.low.y, 0.9f * markings.lift_m);
  EXPECT_LE(paint.high.y, height_at(markings.carriageway, 0.0f) + markings.lift_m + 1e-4f);
}

}  // namespace
}  // namespace litfog::test
