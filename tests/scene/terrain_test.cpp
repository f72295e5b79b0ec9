// SPDX-License-Identifier: Apache-2.0
#include "scene/model/terrain.h"

#include <gtest/gtest.h>

namespace litfog::test {
using namespace scene;

namespace {

TEST(Terrain, GroundLiesUnderTheRoadOnAllItsLength) {
  Terrain terrain;
  terrain.corridor_m = 14.0f;
  terrain.relief_m = 3.0f;
  terrain.path.bend_m = 25.0f;
  for (float along = 0.0f; along <= terrain.path.length_m; along += 3.0f) {
    for (const float offset : {-6.0f, 0.0f, 6.0f}) {
      const glm::vec3 p = terrain.path.point(along, offset);
      EXPECT_LT(height_at(terrain, p.x, p.z), -0.05f) << along << " " << offset;
    }
  }
}

}  // namespace
}  // namespace litfog::test
