// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "fit/branch_and_bound.h"

// The global search for a cone's parameters, for any profile. Internal.

namespace litfog {

/// One or two parameters of a profile.
using ConeParameters = std::array<double, 2>;

/// A range of each parameter.
struct ConeBox {
  ConeParameters least;
  ConeParameters most;
};

/// The narrowest edge of a descent's end, as a fraction of the outer versine: an edge may shrink to a step, which is
/// the limit of cones, but a few units in the last place have no digits.
inline constexpr double kNarrowestEdge = 1e-12;

/// The end of a descent.
struct ConeCandidate {
  ConeParameters parameters{};
  std::size_t lit = 0;  ///< cosine cone: number of points inside its half angle
  double objective = std::numeric_limits<double>::infinity();
  double kkt_residual = 0;
  std::optional<std::vector<double>> covariance = std::nullopt;
};

/// The best parameters of a profile, and what is known of all others.
struct ConeOptimum {
  ConeCandidate best;
  double lower_bound = 0;
  std::size_t boxes = 0;
  std::size_t iterations = 0;
};

/// A profile's search as a problem for branch_and_bound. A profile has
///     root()                      the box of all parameters
///     start(box)                  some parameters in it, unless it holds no cone
///     bound(box, objective)       a lower bound of the objective in the box, given that at its start
///     objective(parameters)
///     descend(start, iterations)  the local minimum below a start
template <typename Profile>
class ConeSearch {
 public:
  ConeSearch(const Profile& profile, double exact) : profile_(profile), exact_(exact) {}

  ConeOptimum run() {
    const BranchAndBoundResult result = branch_and_bound<Evaluation::eager>(*this, kMaxBoxes);
    optimum_.lower_bound = std::min(optimum_.best.objective, result.lower_bound);
    optimum_.boxes = result.boxes;
    return optimum_;
  }

  ConeBox root() const { return profile_.root(); }
  bool contract(ConeBox&) const { return true; }
  bool is_closed(double bound) const {
    return optimum_.best.objective <= exact_ || bound >= (1 - kGap) * optimum_.best.objective;
  }
  double examine(const ConeBox& box) {
    const std::optional<ConeParameters> start = profile_.start(box);
    if (!start) return std::numeric_limits<double>::infinity();
    const double objective = profile_.objective(*start);
    if (objective < optimum_.best.objective) {
      ConeCandidate candidate = profile_.descend(*start, optimum_.iterations);
      if (candidate.objective < optimum_.best.objective) optimum_.best = std::move(candidate);
    }
    const double bound = profile_.bound(box, objective);
    assert(is_below_corners(box, bound));
    return bound;
  }
  std::optional<std::array<ConeBox, 2>> split(const ConeBox& box) const {
    const std::size_t widest = box.most[0] - box.least[0] >= box.most[1] - box.least[1] ? 0 : 1;
    std::array<ConeBox, 2> halves{box, box};
    halves[0].most[widest] = halves[1].least[widest] = (box.least[widest] + box.most[widest]) / 2;
    return halves;
  }

 private:
  /// Whether a bound is below the objective, but for the open gap, at those corners of a box that are cones.
  bool is_below_corners(const ConeBox& box, double bound) const {
    for (const double x : {box.least[0], box.most[0]}) {
      for (const double y : {box.least[1], box.most[1]}) {
        const auto corner = profile_.start({{x, y}, {x, y}});
        if (corner && std::abs(x - y) > kNarrowestEdge * y && bound > profile_.objective(*corner) * (1 + kGap) + exact_)
          return false;
      }
    }
    return true;
  }

  static constexpr std::size_t kMaxBoxes = 1'000'000;
  static constexpr double kGap = 5e-4;  // fraction of the objective that the bounds leave open

  const Profile& profile_;
  double exact_;
  ConeOptimum optimum_;
};

}  // namespace litfog
