// SPDX-License-Identifier: Apache-2.0
#include "fit/active_set.h"

#include <gtest/gtest.h>

#include "reference/double_limits.h"

namespace litfog::test {
namespace {

using Model = BoundedModel<double, 2>;
using Variables = std::vector<std::size_t>;

/// (x - 3)^2 + 4 (y - 2)^2, nowhere bounded.
Model bowl(double x, double y) {
  Model model{
      {x, y}, {2 * (x - 3), 8 * (y - 2)}, Eigen::Matrix2d::Zero(), {-kInfinity, -kInfinity}, {kInfinity, kInfinity}};
  model.curvature.diagonal() << 2, 8;
  return model;
}

TEST(ActiveSet, QuadraticFunctionIsMinimisedInOneStep) {
  const auto [point, blocked] = active_set_step(bowl(-7, 40), {0, 1});
  EXPECT_DOUBLE_EQ(point[0], 3);
  EXPECT_DOUBLE_EQ(point[1], 2);
  EXPECT_FALSE(blocked);
}

TEST(ActiveSet, VariableThatIsNotFreeStays) {
  const auto [point, blocked] = active_set_step(bowl(-7, 40), {1});
  EXPECT_EQ(point[0], -7);
  EXPECT_DOUBLE_EQ(point[1], 2);
}

TEST(ActiveSet, StepEndsOnTheFirstBoundThatItMeets) {
  Model model = bowl(0, 0);
  model.upper = {2, 1};  // the step to (3, 2) meets y = 1 half-way and x = 2 after two thirds
  const auto [point, blocked] = active_set_step(model, {0, 1});
  EXPECT_EQ(blocked, 1u);
  EXPECT_DOUBLE_EQ(point[0], 1.5);
  EXPECT_EQ(point[1], 1) << "exactly";
  model.upper = {0.3, 1};
  EXPECT_EQ(active_set_step(model, {0, 1}).blocked, 0u);
  Model falling = bowl(6, 2.5);
  falling.lower = {4.5, 0};
  EXPECT_EQ(active_set_step(falling, {0, 1}).blocked, 0u);
  EXPECT_EQ(active_set_step(falling, {0, 1}).point, (std::array{4.5, 2.25}));
}

TEST(ActiveSet, StepEndsOnThePlane) {
  for (const auto& start : {std::array{2.0, 0.0}, {5.0, 5.0}}) {  // on it, and off it
    Model model = bowl(start[0], start[1]);
    model.plane = {{1, 1}, 2};
    const auto [point, blocked] = active_set_step(model, {0, 1});  // 2 (x - 3) = 8 (y - 2), x + y = 2
    EXPECT_NEAR(point[0], 0.6, 1e-14);
    EXPECT_NEAR(point[1], 1.4, 1e-14);
  }
}

TEST(ActiveSet, StepDoesNotDependOnTheVariablesUnits) {
  Model model = bowl(-7, 40);
  model.slope[1] *= 0x1p80;
  model.curvature(1, 1) *= 0x1p160;
  model.point[1] *= 0x1p-80;
  const auto [point, blocked] = active_set_step(model, {0, 1});
  EXPECT_DOUBLE_EQ(point[0], 3);
  EXPECT_NEAR(point[1] * 0x1p80, 2, 1e-13);
}

TEST(ActiveSet, VariableIsFreeUnlessADescentWouldCrossItsBound) {
  Model model = bowl(0, 0);
  model.lower = {0, -1};
  model.upper = {5, 0};
  EXPECT_EQ(free_variables(model, {-1, 1}), (Variables{0, 1})) << "both may move inwards";
  EXPECT_EQ(free_variables(model, {1, 1}), (Variables{1}));
  EXPECT_EQ(free_variables(model, {-1, -1}), (Variables{0}));
  EXPECT_EQ(free_variables(model, {0, 0}), Variables{}) << "nothing to gain";
  model.point = {1, -0.5};
  EXPECT_EQ(free_variables(model, {0, 0}), (Variables{0, 1})) << "between its bounds a variable is free";
  model.lower[0] = model.upper[0] = 1;
  EXPECT_EQ(free_variables(model, {-1, -1}), (Variables{1})) << "held";
}

}  // namespace
}  // namespace litfog::test
