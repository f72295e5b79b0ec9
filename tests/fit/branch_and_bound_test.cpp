// SPDX-License-Identifier: Apache-2.0
#include "fit/branch_and_bound.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "reference/double_limits.h"

namespace litfog::test {
namespace {

/// 1 + sin 5x + x^2 / 5, which has eight minima in [-5, 5]; the global one is near -0.3. Slopes are at most 7.
struct Wave {
  struct Box {
    double low, high;
  };

  Box whole = {-5, 5};
  double gap = 1e-6;
  double narrowest = 0;  ///< boxes are split down to this width
  double best_x = kNan;
  double best = kInfinity;
  int tries = 0;

  static double value(double x) { return 1 + std::sin(5 * x) + x * x / 5; }

  Box root() const { return whole; }
  bool contract(Box& box) const {  // x^2 / 5 is nowhere above the function
    const double reach = std::sqrt(5 * std::min(best, 10.0));
    box = {std::max(box.low, -reach), std::min(box.high, reach)};
    return box.low <= box.high;
  }
  double bound(const Box& box) const { return value((box.low + box.high) / 2) - 7 * (box.high - box.low) / 2; }
  double examine(const Box& box) {
    ++tries;
    const double x = (box.low + box.high) / 2;
    if (value(x) < best) {
      best = value(x);
      best_x = x;
    }
    return bound(box);
  }
  bool is_closed(double bound) const { return bound >= best - gap; }
  std::optional<std::array<Box, 2>> split(const Box& box) const {
    const double middle = (box.low + box.high) / 2;
    if (box.high - box.low <= narrowest) return std::nullopt;
    return std::array{Box{box.low, middle}, Box{middle, box.high}};
  }
};

/// Where 5 cos 5x + 2/5 x is 0, bisected.
double lowest_point() {
  double low = -0.35, high = -0.25;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (5 * std::cos(5 * middle) + 0.4 * middle < 0 ? low : high) = middle;
  }
  return low;
}

template <Evaluation kEvaluation>
void expect_global_minimum() {
  Wave wave;
  const BranchAndBoundResult result = branch_and_bound<kEvaluation>(wave, 100'000);
  const double least = Wave::value(lowest_point());
  EXPECT_TRUE(result.is_proven);
  EXPECT_NEAR(wave.best_x, lowest_point(), 1e-3);
  EXPECT_LE(wave.best, least + 1e-6);
  EXPECT_LE(result.lower_bound, least);
  EXPECT_GE(result.lower_bound, wave.best - 1e-6);
  EXPECT_EQ(result.boxes, std::size_t(wave.tries));
  EXPECT_LT(result.boxes, 20'000u) << "of 2^24 of the last boxes' width";
}

TEST(BranchAndBound, EagerSearchFindsTheGlobalMinimumAndBoundsItFromBelow) {
  expect_global_minimum<Evaluation::eager>();
}

TEST(BranchAndBound, LazySearchFindsTheGlobalMinimumAndBoundsItFromBelow) { expect_global_minimum<Evaluation::lazy>(); }

TEST(BranchAndBound, EagerSearchOpensTheBoxWithTheLeastBoundFirst) {
  struct Watched : Wave {
    std::vector<double> opened = {};
    std::optional<std::array<Box, 2>> split(const Box& box) {
      opened.push_back(std::max(0.0, bound(box)));
      return Wave::split(box);
    }
  } wave;
  branch_and_bound<Evaluation::eager>(wave, 1000);
  // A half's bound is not below the whole's, so the least of those that are open only rises.
  for (std::size_t i = 1; i < wave.opened.size(); ++i) EXPECT_GE(wave.opened[i], wave.opened[i - 1] - 1e-12) << i;
  EXPECT_GT(wave.opened.size(), 10u);
}

template <Evaluation kEvaluation>
void expect_honest_limit() {
  Wave wave;
  const BranchAndBoundResult result = branch_and_bound<kEvaluation>(wave, 15);
  EXPECT_FALSE(result.is_proven);
  EXPECT_GE(result.boxes, 15u);
  EXPECT_LE(result.boxes, 16u);
  EXPECT_LT(result.lower_bound, Wave::value(lowest_point()));
}

TEST(BranchAndBound, SearchThatReachesItsLimitProvesNothingButItsBound) {
  expect_honest_limit<Evaluation::eager>();
  expect_honest_limit<Evaluation::lazy>();
}

TEST(BranchAndBound, EmptyRootIsProvenWithoutABox) {
  Wave wave;
  wave.whole = {1, 0};
  for (const auto& result :
       {branch_and_bound<Evaluation::eager>(wave, 100), branch_and_bound<Evaluation::lazy>(wave, 100)}) {
    EXPECT_TRUE(result.is_proven);
    EXPECT_EQ(result.boxes, 0u);
    EXPECT_EQ(result.lower_bound, kInfinity);
  }
}

TEST(BranchAndBound, BoxThatCannotBeSplitStaysInTheLowerBound) {
  Wave wave;
  wave.narrowest = 10;
  const BranchAndBoundResult result = branch_and_bound<Evaluation::lazy>(wave, 100);
  EXPECT_EQ(result.boxes, 1u);
  EXPECT_EQ(result.lower_bound, std::max(0.0, wave.bound(wave.whole)));
}

}  // namespace
}  // namespace litfog::test
