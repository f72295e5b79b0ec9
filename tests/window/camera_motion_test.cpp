// SPDX-License-Identifier: Apache-2.0
#include "window/camera_motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

#include "scene/model/model_catalogue.h"

namespace litfog::test {
using namespace window;

namespace {

constexpr double kTolerance = 2e-6;  // a float's, of coordinates up to 20

scene::Camera camera() { return {.position = {1, 2, 3}, .target = {1, 2, -7}, .field_of_view = 1}; }

void expect_near(const glm::vec3& a, const glm::dvec3& b) {
  EXPECT_LE(glm::distance(glm::dvec3(a), b), 10 * kTolerance) << a.x << " " << a.y << " " << a.z;
}

TEST(CameraMotion, LookingRightTurnsFromMinusZToPlusX) {
  scene::Camera moved = camera();
  look(moved, std::numbers::pi / 2, 0);
  EXPECT_EQ(moved.position, camera().position);
  expect_near(moved.target, {11, 2, 3});
}

TEST(CameraMotion, OrbitingRightMovesTheEyeToPlusXAndKeepsTheTarget) {
  scene::Camera moved = camera();
  orbit(moved, moved.target, std::numbers::pi / 2, 0);
  expect_near(moved.target, camera().target);
  expect_near(moved.position, {11, 2, -7});
}

TEST(CameraMotion, OrbitingUpRaisesTheEye) {
  scene::Camera moved = camera();
  orbit(moved, moved.target, 0, std::numbers::pi / 6);
  expect_near(moved.position, {1, 7, -7 + 10 * std::cos(std::numbers::pi / 6)});
}

TEST(CameraMotion, NeverLooksStraightUpOrDown) {
  for (const double up : {-9.0, 9.0}) {
    for (const bool orbits : {false, true}) {
      scene::Camera moved = camera();
      for (int i = 0; i < 5; ++i) {
        if (orbits)
          orbit(moved, moved.target, 0, up);
        else
          look(moved, 0, up);
      }
      EXPECT_TRUE(scene::has_heading(moved));
      const glm::dvec3 view = glm::normalize(glm::dvec3(moved.target) - glm::dvec3(moved.position));
      EXPECT_NEAR(std::asin(std::abs(view.y)), kSteepest, 1e-4);
      EXPECT_LT(view.z, 0);  // it still faces the same way
    }
  }
}

TEST(CameraMotion, PointThatIsOrbitedStaysWhereItIsInThePicture) {
  const glm::dvec3 pivot(4, 1, -3);
  const auto seen = [&](const scene::Camera& from) {
    const scene::CameraAxes axes = axes_of(from);
    const glm::dvec3 way = pivot - from.position;
    return glm::dvec3(glm::dot(way, axes.right), glm::dot(way, axes.up), glm::dot(way, axes.forward));
  };
  scene::Camera moved = camera();
  orbit(moved, pivot, 0.4, -0.3);
  EXPECT_LE(glm::distance(seen(moved), seen(camera())), 1e-12);
  EXPECT_GT(glm::distance(moved.position, camera().position), 1);
  EXPECT_NEAR(target_distance(moved), 10, 1e-12);
}

TEST(CameraMotion, FlyingKeepsTheViewAndFollowsTheCamerasAxes) {
  scene::Camera moved = camera();
  look(moved, std::numbers::pi / 2, 0);
  fly(moved, 1, 2, 3);  // it looks along +X, its right is +Z
  expect_near(moved.position, {4, 4, 4});
  expect_near(moved.target, {14, 4, 4});
}

TEST(CameraMotion, ApproachingEndsBeforeTheTarget) {
  scene::Camera moved = camera();
  approach(moved, moved.target, 0.5);
  expect_near(moved.position, {1, 2, -2});
  for (int i = 0; i < 100; ++i) approach(moved, moved.target, 0.5);
  EXPECT_NEAR(target_distance(moved), 0.1, kTolerance);
  for (int i = 0; i < 100; ++i) approach(moved, moved.target, 2);
  EXPECT_NEAR(target_distance(moved), 1e5, 0.01);
  moved = camera();
  approach(moved, {1, 5, -1}, 0.5);  // what is not in the middle
  expect_near(moved.position, {1, 3.5, 1});
  expect_near(moved.target, {1, 3.5, -1.5});
}

TEST(CameraMotion, NoStepGoesThroughAWallOrNearerThanTheNearPlaneCuts) {
  scene::Scene scene;
  scene.models = {scene::make_model("box", {{"width_m", 40}, {"depth_m", 0.2}, {"height_m", 40}})};
  scene.instances = {{0, glm::translate(glm::mat4(1), glm::vec3(0, -20, -5))}};
  const measure::TriangleTree wall(scene);  // from z = -4.9 to -5.1
  for (const double step : {0.01, 0.3, 3.0, 50.0}) {
    scene::Camera moved = camera();
    for (int i = 0; i < 2000; ++i) {
      const scene::Camera before = moved;
      fly(moved, 0.1 * step, 0, step);
      stay_before_surfaces(moved, before, wall);
      if (moved.position.x > 15) break;
    }
    EXPECT_GT(moved.position.z, -4.9 + 0.1) << step;
    EXPECT_LT(moved.position.z, -4.9 + 0.2 + 2 * step) << step << ": it comes near";
    const scene::Camera before = moved;
    fly(moved, 0, 0, -0.5);
    stay_before_surfaces(moved, before, wall);
    EXPECT_NE(moved.position, before.position) << step << ": it can go back";
  }
}

}  // namespace
}  // namespace litfog::test
