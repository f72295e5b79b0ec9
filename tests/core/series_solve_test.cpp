// SPDX-License-Identifier: Apache-2.0
#include "solve/series_solve.h"

#include <gtest/gtest.h>

#include <vector>

#include "core/simd_targets.h"
#include "reference/double_limits.h"
#include "reference/random_light.h"

namespace litfog::test {
namespace {

std::vector<SolveCase> ordinary_cases() {
  std::vector<SolveCase> cases;
  Random random(9);
  for (const FogMode mode : kModes) {
    for (int i = 0; i < 50'000; ++i) cases.push_back(draw_ordinary_case(random, mode));
  }
  return cases;
}

TEST(SolveBySeries, EveryTargetComputesTheSameDigits) {
  const std::vector<SolveCase> cases = ordinary_cases();
  std::vector<FogIntensity> expected;
  for_each_simd_target([&](const char*) {
    for (std::size_t i = 0; i < cases.size(); ++i) {
      const auto& [attenuation, fog, threshold] = cases[i];
      const auto solved = solve_by_series(attenuation, fog, threshold);
      ASSERT_TRUE(solved) << to_string(cases[i]);  // no ordinary light is left to the slow way
      if (expected.size() < cases.size()) expected.push_back(*solved);
      ASSERT_EQ(solved->intensity, expected[i].intensity) << to_string(cases[i]);
      ASSERT_EQ(solved->peak_range, expected[i].peak_range) << to_string(cases[i]);
      ASSERT_EQ(solved->extent, expected[i].extent) << to_string(cases[i]);
    }
  });
}

}  // namespace
}  // namespace litfog::test
