// SPDX-License-Identifier: Apache-2.0
#include "render/plan/view.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "render/random_box.h"

namespace litfog::test {
using namespace render;

namespace {

using scene::Bounds;
TEST(Frustum, BoxesBehindTheEyeAreOutOfView) {
  const glm::mat4 clip = glm::infinitePerspective(1.0f, 1.5f, 0.1f) *
                         glm::lookAt(glm::vec3(0, 2, 0), glm::vec3(0, 2, -1), glm::vec3(0, 1, 0));
  const auto frustum = make_frustum(clip);
  EXPECT_TRUE(can_see(frustum, {{-1, 0, -12}, {1, 2, -10}}));
  EXPECT_TRUE(can_see(frustum, {{-1, 0, -1e6f}, {1, 2, -1e5f}}));
  EXPECT_FALSE(can_see(frustum, {{-1, 0, 10}, {1, 2, 12}}));
  EXPECT_FALSE(can_see(frustum, {{50, 0, -12}, {52, 2, -10}}));
}

TEST(Frustum, BoxOfWhichAPointIsInThePictureIsInView) {
  Random random(7);
  int visible = 0;
  for (int i = 0; i < 20'000; ++i) {
    const glm::vec3 eye = random_point(random, 20);
    const glm::mat4 clip = glm::infinitePerspective(float(random.uniform(0.2, 2)), 1.5f, 0.1f) *
                           glm::lookAt(eye, eye + glm::vec3(random_point(random, 1)), glm::vec3(0, 1, 0));
    const auto frustum = make_frustum(clip);
    const Bounds box = random_box(random);
    const glm::vec4 seen = clip * glm::vec4(glm::vec3(random_point_in(random, box)), 1.0f);
    if (!glm::all(glm::lessThanEqual(glm::abs(glm::vec3(seen)), glm::vec3(seen.w)))) continue;
    ++visible;
    ASSERT_TRUE(can_see(frustum, box)) << "case " << i;
  }
  EXPECT_GT(visible, 500);
}

}  // namespace

}  // namespace litfog::test
