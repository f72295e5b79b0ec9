// SPDX-License-Identifier: Apache-2.0
#include "scene/noise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace litfog::test {
using namespace scene;

namespace {

TEST(Noise, GradientNoiseHasMeanZeroAndIsBounded) {
  double sum = 0.0;
  float most = 0.0f;
  constexpr int kSide = 400;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const float value = gradient_noise(0.37f * float(x), 0.41f * float(y) - 50.0f, 3);
      sum += value;
      most = std::max(most, std::abs(value));
    }
  }
  EXPECT_NEAR(sum / (kSide * kSide), 0.0, 0.01);
  EXPECT_GT(most, 0.5f);
  EXPECT_LT(most, 1.0f);
}

}  // namespace
}  // namespace litfog::test
