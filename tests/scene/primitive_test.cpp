// SPDX-License-Identifier: Apache-2.0
#include "scene/model/primitive.h"

#include <gtest/gtest.h>

namespace litfog::test {
using namespace scene;

namespace {

TEST(Primitive, BeamReachesFromEndToEnd) {
  const Bounds box = bounds(make_beam({0.0f, 1.0f, 0.0f}, {0.0f, 1.0f, -5.0f}, 0.2f, 0.4f));
  EXPECT_NEAR(glm::distance(box.low, glm::vec3(-0.1f, 0.8f, -5.0f)), 0.0f, 1e-5f);
  EXPECT_NEAR(glm::distance(box.high, glm::vec3(0.1f, 1.2f, 0.0f)), 0.0f, 1e-5f);
}

}  // namespace
}  // namespace litfog::test
