// SPDX-License-Identifier: Apache-2.0
#include "measure/triangle_tree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

#include "reference/random_light.h"
#include "scene/model/primitive.h"

namespace litfog::test {
using namespace measure;

namespace {

/// Boxes of an edge of 1 m at whole places, every third missing.
scene::Scene boxes() {
  scene::Scene scene;
  scene.models.push_back({scene::Part{"plain", scene::make_box({1, 1, 1})}});
  for (int x = 0; x < 6; ++x) {
    for (int z = 0; z < 6; ++z) {
      if ((x + z) % 3 == 0) continue;
      scene.instances.push_back({0, glm::translate(glm::mat4(1), glm::vec3(2 * x, 0, 2 * z))});
    }
  }
  return scene;
}

/// Metres along a ray to the nearest of the boxes' sides, in closed form; infinity where it meets none.
double distance_to_boxes(const scene::Scene& scene, const glm::dvec3& origin, const glm::dvec3& direction) {
  const scene::Bounds unit = scene::bounds(scene.models[0]);
  double nearest = std::numeric_limits<double>::infinity();
  for (const scene::Instance& instance : scene.instances) {
    const glm::dvec3 place = glm::dvec3(instance.world_from_model[3]);
    double enters = -nearest;
    double leaves = std::numeric_limits<double>::infinity();
    for (glm::length_t i = 0; i < 3; ++i) {
      const double a = (unit.low[i] + place[i] - origin[i]) / direction[i];
      const double b = (unit.high[i] + place[i] - origin[i]) / direction[i];
      enters = std::max(enters, std::min(a, b));
      leaves = std::min(leaves, std::max(a, b));
    }
    if (enters < leaves && enters > 0) nearest = std::min(nearest, enters);
  }
  return nearest;
}

TEST(TriangleTree, RayMeetsTheBoxesThatItMeetsInClosedForm) {
  const scene::Scene scene = boxes();
  const TriangleTree tree(scene);
  Random random(3);
  int met = 0;
  for (int i = 0; i < 20'000; ++i) {
    const double x = random.uniform(-3, 14);
    const double z = random.uniform(-3, 14);
    const glm::dvec3 origin(x, random.uniform(2, 19), z);  // above them
    const glm::dvec3 direction = draw_direction(random);
    const double expected = distance_to_boxes(scene, origin, direction);
    const auto hit = tree.nearest(origin, direction, 0, 1000);
    ASSERT_EQ(hit.has_value(), expected < 1000) << i;
    EXPECT_EQ(tree.is_met(origin, direction, 0, 1000), hit.has_value());
    if (!hit) continue;
    ++met;
    EXPECT_NEAR(hit->distance, expected, 1e-9);
    EXPECT_NEAR(std::abs(hit->normal.x) + std::abs(hit->normal.y) + std::abs(hit->normal.z), 1, 1e-12);
    EXPECT_FALSE(tree.is_met(origin, direction, 0, expected - 1e-9));
    EXPECT_TRUE(tree.is_met(origin, direction, expected - 1e-9, expected + 1e-9));
  }
  EXPECT_GT(met, 500);
}

TEST(TriangleTree, RayAlongAnAxisMeetsWhatItIsAimedAt) {
  const TriangleTree tree(boxes());
  EXPECT_TRUE(tree.is_met({2, 9, 0}, {0, -1, 0}, 0, 100));
  EXPECT_FALSE(tree.is_met({0, 9, 0}, {0, -1, 0}, 0, 100));
  EXPECT_FALSE(tree.is_met({2, 9, 0}, {0, 1, 0}, 0, 100));
}

TEST(TriangleTree, SceneWithoutTrianglesIsNeverMet) {
  EXPECT_FALSE(TriangleTree(scene::Scene{}).is_met({}, {0, 1, 0}, 0, 1e9));
}

}  // namespace

}  // namespace litfog::test
