// SPDX-License-Identifier: Apache-2.0
#include "window/visibility_preset.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace litfog::test {
using namespace window;

namespace {

TEST(VisibilityPreset, EachLiesOnTheSliderAndTheyAscend) {
  EXPECT_TRUE(std::ranges::is_sorted(kVisibilityPresets, {}, &VisibilityPreset::metres));
  for (const VisibilityPreset& preset : kVisibilityPresets) {
    EXPECT_TRUE(std::isinf(preset.metres) || (preset.metres >= kLeastVisibility && preset.metres <= kMostVisibility))
        << preset.name;
  }
}

TEST(VisibilityPreset, MeaningsOfCategoriesStateTheirMetres) {
  for (const VisibilityPreset& preset : kVisibilityPresets) {
    if (!std::string(preset.name).starts_with("CAT")) continue;
    EXPECT_NE(std::string(preset.meaning).find(": " + std::to_string(int(preset.metres)) + " m"), std::string::npos);
  }
}

}  // namespace

}  // namespace litfog::test
