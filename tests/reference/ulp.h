// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include "reference/digits50.h"
#include "reference/error_tally.h"

// How far the values of a function are from their references: the one comparison of the accuracy tests.

namespace litfog::test {

/// A tally that a test checks.
class WorstError : public ErrorTally {
 public:
  using ErrorTally::ErrorTally;

  /// Prints the line and fails where the bound is exceeded or nothing was tried.
  void check() const {
    print();
    EXPECT_TRUE(is_within_bound()) << worst() << ": " << worst_case();
  }
};

}  // namespace litfog::test
