// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
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

/// Steps to the model's stationary point in the free variables, or towards it up to the first bound. If there is a
/// plane, the free variable with the largest term on it follows the others, so that no rounding leads away from it.
template <typename Real, std::size_t kSize>
ActiveSetStep<Real, kSize> active_set_step(const BoundedModel<Real, kSize>& model,
                                           const std::vector<std::size_t>& free) {
  using Eigen::Index;
  constexpr int kMost = int(kSize);
  if (free.empty()) return {model.point, std::nullopt};
  auto chosen = free;
  std::optional<std::size_t> last;  // the one that follows
  if (model.plane) {
    last = *std::ranges::max_element(free, {},
                                     [&](std::size_t j) { return std::abs(model.plane->normal[j] * model.point[j]); });
    std::erase(chosen, *last);
  }
  // A column for each variable that is chosen freely: the change of all by a change of it.
  Eigen::Matrix<Real, kMost, Eigen::Dynamic, 0, kMost, kMost> columns;
  columns.setZero(kMost, Index(chosen.size()));
  for (std::size_t m = 0; m < chosen.size(); ++m) {
    columns(Index(chosen[m]), Index(m)) = 1;
    if (last) columns(Index(*last), Index(m)) = -model.plane->normal[chosen[m]] / model.plane->normal[*last];
  }
  // Each in units of its own curvature, so that the rank does not depend on units.
  const Eigen::Map<const Eigen::Matrix<Real, kMost, 1>> slope(model.slope.data());
  for (Index m = 0; m < columns.cols(); ++m) {
    const Real curvature = std::abs(columns.col(m).dot(model.curvature * columns.col(m)));
    if (curvature > 0) columns.col(m) /= std::sqrt(curvature);
  }
  Eigen::Matrix<Real, kMost, 1> step = Eigen::Matrix<Real, kMost, 1>::Zero();
  if (last) {
    const auto& [normal, value] = *model.plane;
    step[Index(*last)] =
        (value - std::inner_product(normal.begin(), normal.end(), model.point.begin(), Real(0))) / normal[*last];
  }
  if (columns.cols() > 0) {
    const auto system = (columns.transpose() * model.curvature * columns).eval();
    step += columns * system.fullPivLu().solve(-columns.transpose() * (slope + model.curvature * step));
  }

  Real fraction = 1, bound = 0;
  std::optional<std::size_t> blocked;
  for (const std::size_t j : free) {
    const Real change = step[Index(j)];
    const Real limit = change < 0 ? model.lower[j] : model.upper[j];
    const Real end = model.point[j] + fraction * change;
    const bool is_beyond = change < 0 ? end < limit : end > limit;
    if (!is_beyond) continue;
    fraction = (limit - model.point[j]) / change;
    bound = limit;
    blocked = j;
  }
  ActiveSetStep<Real, kSize> result{model.point, blocked};
  for (const std::size_t j : free) result.point[j] += fraction * step[Index(j)];
  if (blocked) result.point[*blocked] = bound;
  return result;
}

}  // namespace litfog
