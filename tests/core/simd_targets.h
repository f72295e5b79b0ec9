// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cstdint>

namespace litfog::test {

/// Runs a test, which gets the target's name, on every SIMD target that this processor has, the best first. Ends with
/// the first fatal failure.
template <typename Test>
void for_each_simd_target(const Test& test) {
  for (std::int64_t targets = hwy::SupportedTargets(); targets != 0; targets &= targets - 1) {
    hwy::SetSupportedTargetsForTest(targets);
    SCOPED_TRACE(hwy::TargetName(targets & -targets));
    test(hwy::TargetName(targets & -targets));
    if (testing::Test::HasFatalFailure()) break;
  }
  hwy::SetSupportedTargetsForTest(0);
}

}  // namespace litfog::test
