// SPDX-License-Identifier: Apache-2.0
#include "scene/paint/field.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scene/noise.h"

namespace litfog::test {
using namespace scene;

namespace {

TEST(Field, NoiseRepeats) {
  Field field(64);
  add_noise(field, 8, 4, 1.0f, 7);
  // The two halves differ, and the wrapped neighbours are as close as those inside.
  double across_border = 0.0;
  double inside = 0.0;
  for (int y = 0; y < 64; ++y) {
    across_border += std::abs(field.at(63, y) - field.at(64, y));
    inside += std::abs(field.at(31, y) - field.at(32, y));
  }
  EXPECT_LT(across_border, 3.0 * inside);
  EXPECT_NE(field.at(5, 5), field.at(37, 5));
}

TEST(Field, NoiseEqualsThatOfThePointFormula) {
  // Within the tile, away from the lattice column that wraps.
  Field field(64);
  add_noise(field, 8, 8, 1.0f, 7);
  for (int y = 0; y < 56; ++y) {
    for (int x = 0; x < 56; ++x) {
      EXPECT_NEAR(field.at(x, y), gradient_noise(float(x) / 8.0f, float(y) / 8.0f, 7), 1e-5f);
    }
  }
}

TEST(Field, OtherSeedsGiveOtherNoise) {
  const Field a = make_octaves(64, 4, 3, 1);
  const Field b = make_octaves(64, 4, 3, 100);
  double difference = 0.0;
  for (std::size_t i = 0; i < a.texels(); ++i) difference += std::abs(a[i] - b[i]);
  EXPECT_GT(difference / 4096.0, 0.1);
}

}  // namespace
}  // namespace litfog::test
