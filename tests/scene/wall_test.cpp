// SPDX-License-Identifier: Apache-2.0
#include "scene/model/wall.h"

#include <gtest/gtest.h>

#include <span>

namespace litfog::test {
using namespace scene;

namespace {

TEST(Wall, WallLeavesItsOpeningsFree) {
  const Opening window{1.0f, 1.0f, 2.0f, 2.0f};
  const Mesh wall = make_wall(4.0f, 3.0f, std::span(&window, 1), 0.2f);
  float front = 0.0f;
  for (std::size_t i = 0; i + 2 < wall.indices.size(); i += 3) {
    const Vertex& a = wall.vertices[wall.indices[i]];
    if (a.normal.z < 0.9f) continue;
    const glm::vec3 ab = wall.vertices[wall.indices[i + 1]].position - a.position;
    const glm::vec3 ac = wall.vertices[wall.indices[i + 2]].position - a.position;
    front += 0.5f * glm::length(glm::cross(ab, ac));
  }
  EXPECT_NEAR(front, 11.0f, 1e-4f);
}

}  // namespace
}  // namespace litfog::test
