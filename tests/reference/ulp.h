// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

#include "reference/digits50.h"

// How far the values of a function are from their references: the one comparison of the accuracy tests.

namespace litfog::test {

/// One line of the accuracy table: function, range, bound, worst found.
class WorstError {
 public:
  WorstError(std::string function, std::string range, double bound, std::string unit = "ulp")
      : function_(std::move(function)), range_(std::move(range)), unit_(std::move(unit)), bound_(bound) {}

  /// describe() names the case; it is called for the worst only.
  template <typename Describe>
  void add(double error, const Describe& describe) {
    ++cases_;
    if (error <= worst_) return;
    worst_ = std::isnan(error) ? std::numeric_limits<double>::infinity() : error;
    worst_case_ = describe();
  }

  double worst() const { return worst_; }

  /// Prints the line and fails where the bound is exceeded or nothing was tried.
  void check() const {
    std::printf("%-22s %-46s bound %8.3g %s, worst %9.4g in %d\n", function_.c_str(), range_.c_str(), bound_,
                unit_.c_str(), worst_, cases_);
    EXPECT_GT(cases_, 0) << function_ << ", " << range_;
    EXPECT_LE(worst_, bound_) << function_ << ", " << range_ << ": " << worst_case_;
  }

 private:
  std::string function_;
  std::string range_;
  std::string unit_;
  std::string worst_case_;
  double bound_;
  double worst_ = 0;
  int cases_ = 0;
};

}  // namespace litfog::test
