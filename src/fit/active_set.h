// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

// Newton's method for a few variables within bounds, by active sets (Nocedal and Wright, "Numerical Optimization",
// 2nd edition, 16.5). Internal.

namespace litfog {

/// A second-order model of an objective about a point, with bounds of the variables. lower = upper fixes a variable.
template <typename Real, std::size_t kSize>
struct BoundedModel {
  using Variables = std::array<Real, kSize>;
  /// The plane normal . variables = value.
  struct Plane {
    Variables normal;
    Real value;
  };

  Variables point;
  Variables slope;
  Eigen::Matrix<Real, int(kSize), int(kSize)> curvature;
  Variables lower;
  Variables upper;
  std::optional<Plane> plane = {};
};

/// The free variables, those not at a bound that a descent would cross.
/// slope  the objective's slope, along the plane if there is one
template <typename Real, std::size_t kSize>
std::vector<std::size_t> free_variables(const BoundedModel<Real, kSize>& model, const std::array<Real, kSize>& slope) {
  std::vector<std::size_t> free;
  for (std::size_t j = 0; j < kSize; ++j) {
    if (model.lower[j] == model.upper[j]) continue;
    const bool may_rise = model.point[j] < model.upper[j];
    const bool may_fall = model.point[j] > model.lower[j];
    if ((may_rise && may_fall) || (may_rise ? slope[j] < 0 : slope[j] > 0)) free.push_back(j);
  }
  return free;
}

template <typename Real, std::size_t kSize>
struct ActiveSetStep {
  std::array<Real, kSize> point;       ///< the end of the step
  std::optional<std::size_t> blocked;  ///< the variable whose bound ended it early
};

/// Steps to the model's stationary point in the free variables, or towards it up to the first bound.
template <typename Real, std::size_t kSize>
ActiveSetStep<Real, kSize> active_set_step(const BoundedModel<Real, kSize>& model,
                                           const std::vector<std::size_t>& free) {
  using Eigen::Index;
  if (free.empty()) return {model.point, std::nullopt};
  constexpr int kMost = int(kSize) + 1;
  const auto count = Index(free.size());
  const Index size = count + (model.plane ? 1 : 0);
  // Each variable in units of its own curvature, so that the rank does not depend on units; a last row and column for
  // the plane and its multiplier.
  Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic, 0, kMost, kMost> system(size, size);
  Eigen::Matrix<Real, Eigen::Dynamic, 1, 0, kMost, 1> right(size), unit(count);
  system.setZero();
  for (Index j = 0; j < count; ++j) {
    const auto at = free[std::size_t(j)];
    const Real curvature = std::abs(model.curvature(Index(at), Index(at)));
    unit[j] = curvature > 0 ? 1 / std::sqrt(curvature) : 1;
    for (Index k = 0; k <= j; ++k) {
      system(j, k) = system(k, j) = unit[j] * unit[k] * model.curvature(Index(at), Index(free[std::size_t(k)]));
    }
    right[j] = -unit[j] * model.slope[at];
  }
  if (model.plane) {
    const auto& [normal, value] = *model.plane;
    Real sum = 0, largest = 0;
    for (std::size_t j = 0; j < kSize; ++j) sum += model.point[j] * normal[j];
    for (Index j = 0; j < count; ++j) largest = std::max(largest, std::abs(unit[j] * normal[free[std::size_t(j)]]));
    for (Index j = 0; j < count; ++j) {
      system(j, count) = system(count, j) = unit[j] * normal[free[std::size_t(j)]] / largest;
    }
    right[count] = (value - sum) / largest;
  }
  const auto step = system.fullPivLu().solve(right).eval();

  Real fraction = 1, bound = 0;
  std::optional<std::size_t> blocked;
  for (Index m = 0; m < count; ++m) {
    const std::size_t j = free[std::size_t(m)];
    const Real change = unit[m] * step[m];
    const Real limit = change < 0 ? model.lower[j] : model.upper[j];
    const Real end = model.point[j] + fraction * change;
    const bool is_beyond = change < 0 ? end < limit : end > limit;
    if (!is_beyond) continue;
    fraction = (limit - model.point[j]) / change;
    bound = limit;
    blocked = j;
  }
  ActiveSetStep<Real, kSize> result{model.point, blocked};
  for (Index m = 0; m < count; ++m) result.point[free[std::size_t(m)]] += fraction * unit[m] * step[m];
  if (blocked) result.point[*blocked] = bound;
  return result;
}

}  // namespace litfog
