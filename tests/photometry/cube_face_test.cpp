// SPDX-License-Identifier: Apache-2.0
#include "litfog/photometry/cube_face.h"

#include <gtest/gtest.h>

#include "reference/random_light.h"

namespace litfog::test {
namespace {

TEST(CubeFace, FacesLookAlongTheirAxes) {
  const glm::dvec3 axes[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  for (int face = 0; face < 6; ++face) EXPECT_EQ(cube_direction({face, 0, 0}), axes[face]);
}

TEST(CubeFace, PositionsAreThoseOfTheirDirections) {
  Random random(8);
  for (int i = 0; i < 2000; ++i) {
    const int face = i % 6;
    const double u = random.uniform(-0.99, 0.99);
    const double v = random.uniform(-0.99, 0.99);
    const CubePosition position = cube_position(cube_direction({face, u, v}) * random.uniform(0.1, 9));
    EXPECT_EQ(position.face, face);
    EXPECT_NEAR(position.u, u, 1e-14);
    EXPECT_NEAR(position.v, v, 1e-14);
  }
}

}  // namespace
}  // namespace litfog::test
