// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <utility>

#include "reference/digits50.h"

namespace litfog::test {

/// The errors of one function over one range of arguments, and the bound on the largest: a line of the accuracy table,
/// and the one comparison of the accuracy tests. NaN counts as infinitely wrong.
class WorstError {
 public:
  WorstError(std::string function, std::string range, double bound, std::string unit = "ulp")
      : function_(std::move(function)), range_(std::move(range)), unit_(std::move(unit)), bound_(bound) {}

  /// describe() names the case; it is called for the worst only.
  template <typename Describe>
  void add(double error, const Describe& describe) {
    if (std::isnan(error)) error = std::numeric_limits<double>::infinity();
    ++cases_;
    sum_ += error;
    if (error <= worst_) return;
    worst_ = error;
    worst_case_ = describe();
  }

  double worst() const { return worst_; }

  /// Prints the line and fails where the bound is exceeded or nothing was tried.
  void check() const {
    std::printf("%-30s %-46s bound %8.3g %s, worst %9.4g, mean %9.4g in %lld\n", function_.c_str(), range_.c_str(),
                bound_, unit_.c_str(), worst_, sum_ / double(cases_), cases_);
    EXPECT_TRUE(cases_ > 0 && worst_ <= bound_) << worst_ << ": " << worst_case_;
  }

 private:
  std::string function_;
  std::string range_;
  std::string unit_;
  std::string worst_case_;
  double bound_;
  double worst_ = 0;
  double sum_ = 0;
  long long cases_ = 0;
};

}  // namespace litfog::test
