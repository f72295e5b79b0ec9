// SPDX-License-Identifier: Apache-2.0
#include "scene/camera.h"

#include <gtest/gtest.h>

namespace litfog::scene {
namespace {

TEST(Camera, AxesAreTheViewsAxesInTheWorld) {
  const Camera camera{.position = {3, -2, 5}, .target = {-1, 4, 2}, .field_of_view = 1};
  const CameraAxes axes = axes_of(camera);
  const glm::dmat3 view = view_from_world<double>(camera);
  EXPECT_LT(glm::distance(view * axes.right, glm::dvec3(1, 0, 0)), 1e-15);
  EXPECT_LT(glm::distance(view * axes.up, glm::dvec3(0, 1, 0)), 1e-15);
  EXPECT_LT(glm::distance(view * axes.forward, glm::dvec3(0, 0, -1)), 1e-15);
  EXPECT_GT(axes.up.y, 0);
  EXPECT_LT(glm::distance(view_from_world<double>(camera) * glm::dvec4(3, -2, 5, 1), glm::dvec4(0, 0, 0, 1)), 1e-15);
}

TEST(Camera, CameraThatLooksStraightUpOrDownHasNoHeading) {
  EXPECT_TRUE(has_heading({}));
  EXPECT_FALSE(has_heading({.position = {1, 2, 3}, .target = {1, 9, 3}}));
  EXPECT_FALSE(has_heading({.position = {1, 2, 3}, .target = {1, 2, 3}}));
}

}  // namespace
}  // namespace litfog::scene
