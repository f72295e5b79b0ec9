// SPDX-License-Identifier: Apache-2.0
#include "scene/srgb.h"

#include <gtest/gtest.h>

#include "reference/srgb.h"

namespace litfog::test {
namespace {

TEST(Srgb, ValuesAreThoseOfTheStandardBothWays) {
  constexpr int kSteps = 4096;
  for (int i = 0; i <= kSteps; ++i) {
    const float x = float(i) / kSteps;
    ASSERT_NEAR(double(scene::srgb_from_linear(x)), srgb_from_linear(double(x)), 1e-6) << x;
    ASSERT_NEAR(double(scene::linear_from_srgb(x)), linear_from_srgb(double(x)), 1e-6) << x;
  }
}

TEST(Srgb, ValuesBeyondTheDisplayAreClamped) {
  for (const float x : {-1.0f, 2.0f}) {
    EXPECT_EQ(scene::srgb_from_linear(x), x < 0 ? 0.0f : scene::srgb_from_linear(1.0f));
    EXPECT_EQ(scene::linear_from_srgb(x), x < 0 ? 0.0f : scene::linear_from_srgb(1.0f));
  }
}

}  // namespace
}  // namespace litfog::test
