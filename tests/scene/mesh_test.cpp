// SPDX-License-Identifier: Apache-2.0
#include "scene/mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <string>

#include "mesh_faults.h"
#include "reference/double_limits.h"
#include "reference/random_airlight.h"
#include "scene/model/primitive.h"

namespace litfog::test {
using namespace scene;

namespace {

TEST(Mesh, BoundsEncloseABox) {
  const Bounds box = bounds(make_box({2.0f, 3.0f, 4.0f}));
  EXPECT_EQ(box.low, glm::vec3(-1.0f, 0.0f, -2.0f));
  EXPECT_EQ(box.high, glm::vec3(1.0f, 3.0f, 2.0f));
}

TEST(Mesh, DistancesToABoxAreThoseToItsPoints) {
  Random random(23);
  for (int i = 0; i < 1000; ++i) {
    const glm::dvec3 eye = draw_direction(random) * random.uniform(0, 20);
    const glm::vec3 low(random.uniform(-10, 0), random.uniform(-10, 0), random.uniform(-10, 0));
    const glm::vec3 high = low + glm::vec3(random.uniform(0, 10), random.uniform(0, 10), random.uniform(0, 10));
    const Bounds box{low, high};
    double nearest = kInfinity;
    double farthest = 0;
    for (int j = 0; j < 20; ++j) {
      const auto along = [&](int axis) {
        return random.chance(0.3) ? double(random.chance(0.5) ? low[axis] : high[axis])
                                  : random.uniform(double(low[axis]), double(high[axis]));
      };
      const double distance = glm::distance(eye, glm::dvec3(along(0), along(1), along(2)));
      nearest = std::min(nearest, distance);
      farthest = std::max(farthest, distance);
    }
    EXPECT_LE(nearest_distance(eye, box), nearest);
    EXPECT_GE(farthest_distance(eye, box), farthest);
    double gap = 0;  // squared, as is the way to the farther face along each axis
    double way = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double below = double(low[axis]) - eye[axis];
      const double above = eye[axis] - double(high[axis]);
      gap += std::pow(std::max({below, above, 0.0}), 2);
      way += std::pow(std::min(below, above), 2);
    }
    EXPECT_NEAR(nearest_distance(eye, box), std::sqrt(gap), 1e-12);
    EXPECT_NEAR(farthest_distance(eye, box), std::sqrt(way), 1e-12);
  }
  EXPECT_EQ(nearest_distance({0, 0, 0}, {{-1, -1, -1}, {1, 1, 1}}), 0);
}

TEST(Mesh, AppendingAMirroredMeshKeepsFrontFacesInFront) {
  Model mirrored;
  append(part(mirrored, "stone"), make_bevelled_box({1.0f, 2.0f, 3.0f}, 0.2f),
         glm::scale(glm::mat4(1.0f), glm::vec3(-1.0f, 1.0f, 2.0f)));
  const Faults faults = faults_of(mirrored);
  EXPECT_EQ(faults.facing_away, 0);
  EXPECT_EQ(faults.tangents_against_u, 0);
  EXPECT_EQ(faults.normals_not_unit, 0);
}

TEST(Mesh, ReferenceToAPartOutlivesLaterParts) {
  Model model;
  Mesh& first = part(model, "stone");
  for (int i = 0; i < 100; ++i) part(model, "material " + std::to_string(i));
  EXPECT_EQ(&first, &part(model, "stone"));
  EXPECT_EQ(model.size(), 101u);
}

TEST(Mesh, PlacementTurnsCounterclockwiseSeenFromAbove) {
  const glm::vec3 turned(place({1.0f, 2.0f, 3.0f}, glm::radians(90.0f)) * glm::vec4(1.0f, 0.0f, 0.0f, 1.0f));
  EXPECT_NEAR(glm::distance(turned, glm::vec3(1.0f, 2.0f, 2.0f)), 0.0f, 1e-6f);
}

// Between vertices whose tangents jump, what the vertices carry into tangent space is interpolated to nonsense.
TEST(Mesh, TangentsWithoutTextureCoordinatesTurnWithTheNormal) {
  constexpr int kSteps = 64;
  const auto tangent = [](int ring, int turn) {
    const double polar = 0.9 * 3.14159 * ring / kSteps;  // all but straight down
    const double around = 2 * 3.14159 * turn / kSteps;
    const glm::vec3 normal(std::sin(polar) * std::sin(around), std::cos(polar), std::sin(polar) * std::cos(around));
    Mesh mesh;
    mesh.vertices.push_back({normal, normal, {}, {}});
    compute_tangents(mesh);
    EXPECT_NEAR(glm::dot(normal, glm::vec3(mesh.vertices[0].tangent)), 0, 1e-6);
    return glm::vec3(mesh.vertices[0].tangent);
  };
  for (int ring = 0; ring < kSteps; ++ring) {
    for (int turn = 0; turn < kSteps; ++turn) {
      // The frame is a turn by the polar angle about a level axis, which itself turns with the normal: a step around
      // turns the tangent back and forth.
      EXPECT_LT(glm::distance(tangent(ring, turn), tangent(ring + 1, turn)), 0.9 * 3.1416 / kSteps);
      EXPECT_LT(glm::distance(tangent(ring, turn), tangent(ring, turn + 1)), 2 * 2 * 3.1416 / kSteps);
    }
  }
}

TEST(Bounds, TransformedBoxHoldsItsTransformedCorners) {
  const Bounds box{{-1, 0, 2}, {3, 1, 4}};
  const glm::mat4 turn = glm::translate(glm::rotate(glm::mat4(1), 0.7f, glm::vec3(0.6f, 0.8f, 0)), {5, 6, 7});
  const Bounds around = transformed(box, turn);
  for (int corner = 0; corner < 8; ++corner) {
    const glm::vec3 at{corner & 1 ? box.high.x : box.low.x, corner & 2 ? box.high.y : box.low.y,
                       corner & 4 ? box.high.z : box.low.z};
    const glm::vec3 moved = glm::vec3(turn * glm::vec4(at, 1));
    EXPECT_TRUE(glm::all(glm::lessThanEqual(around.low, moved + 1e-4f)));
    EXPECT_TRUE(glm::all(glm::lessThanEqual(moved, around.high + 1e-4f)));
  }
}

}  // namespace
}  // namespace litfog::test
