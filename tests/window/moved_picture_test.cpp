// SPDX-License-Identifier: Apache-2.0
#include "window/moved_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <utility>

#include "scene/model/model_catalogue.h"
#include "window/camera_motion.h"
#include "window/light_pick.h"

namespace litfog::test {
using namespace window;

namespace {

constexpr double kDrawnAspect = 16.0 / 9;
constexpr double kAspect = 1.5;  // the panel's may have changed

scene::Camera drawn() { return {.position = {3, 2, 5}, .target = {-1, 1, -20}, .field_of_view = 0.9f}; }

scene::Camera moved() {
  scene::Camera camera = drawn();
  look(camera, 0.1, -0.05);
  fly(camera, 0.7, 0.2, 1.5);
  return camera;
}

/// The walls of a box around both cameras.
class MovedPictureOfABox : public testing::Test {
 protected:
  static scene::Scene box() {
    scene::Scene scene;
    scene.models = {scene::make_model("box", {{"width_m", 40}, {"depth_m", 60}, {"height_m", 20}})};
    scene.instances = {{0, glm::translate(glm::mat4(1), glm::vec3(0, -10, 0))}};
    return scene;
  }

  const scene::Scene scene_ = box();
  const measure::TriangleTree walls_{scene_};
};

/// The largest distance, as a fraction of the picture, between where the mesh has points of the walls in the drawn
/// picture and where its camera sees them.
double largest_error(const MovedPicture& picture, const scene::Camera& camera, double aspect,
                     const measure::TriangleTree& walls) {
  double largest = 0;
  int cells = 0;
  for (int row = 0; row < MovedPicture::kRows; ++row) {
    for (int column = 0; column < MovedPicture::kColumns; ++column) {
      const auto low = picture.source(column, row), high = picture.source(column + 1, row + 1);
      if (!low || !high) continue;
      ++cells;
      const glm::dvec2 middle = (MovedPicture::place(column, row) + MovedPicture::place(column + 1, row + 1)) / 2.0;
      const EyeRay ray = ray_through(camera, aspect, middle);
      const auto hit = walls.nearest(ray.origin, ray.direction, 0, kFarthestSurface);
      const auto seen = place_in_picture(drawn(), kDrawnAspect, ray.origin + hit.value().distance * ray.direction);
      largest = std::max(largest, glm::distance((*low + *high) / 2.0, seen.value()));
    }
  }
  EXPECT_GT(cells, MovedPicture::kColumns * MovedPicture::kRows * 3 / 4);
  return largest;
}

TEST(MovedPicture, PictureStaysWhileTheCameraStays) {
  const MovedPicture still(drawn(), kAspect, drawn(), kAspect, nullptr);
  for (const auto& [column, row] : {std::pair(0, 0), std::pair(48, 27), std::pair(17, 5)}) {
    EXPECT_LE(glm::distance(still.source(column, row).value(), MovedPicture::place(column, row)), 1e-12);
  }
}

TEST_F(MovedPictureOfABox, PointsOfSurfacesAreWhereTheCameraHasMovedThem) {
  EXPECT_LT(largest_error({drawn(), kDrawnAspect, moved(), kAspect, &walls_}, moved(), kAspect, walls_), 0.004);
  scene::Camera turned = drawn();
  look(turned, -0.2, 0.1);
  EXPECT_LT(largest_error({drawn(), kDrawnAspect, turned, kAspect, nullptr}, turned, kAspect, walls_), 0.001)
      << "a camera that only turns needs no surfaces";
}

TEST(MovedPicture, WhatWasBehindTheCameraOrFarOutsideIsMissing) {
  scene::Camera turned = drawn();
  look(turned, 2.5, 0);
  const MovedPicture picture(drawn(), kAspect, turned, kAspect, nullptr);
  EXPECT_FALSE(picture.source(MovedPicture::kColumns / 2, MovedPicture::kRows / 2));
  scene::Camera aside = drawn();
  look(aside, 0.6, 0);
  const MovedPicture beside(drawn(), kAspect, aside, kAspect, nullptr);
  EXPECT_TRUE(beside.source(0, MovedPicture::kRows / 2));
  EXPECT_FALSE(beside.source(MovedPicture::kColumns, MovedPicture::kRows / 2));
}

}  // namespace
}  // namespace litfog::test
