// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "fit/cone_point.h"
#include "fit/cone_search.h"

// Internal.

namespace litfog {

/// cos^S u for u < H, as a profile of ConeSearch. H alone decides which points are lit, and one pass over the points
/// finds the best choice for an S, so the search is over S alone. Its parameter is 1 / (1 + S m), m = -ln cos u of a
/// typical point, in [0, 1].
class CosineProfile {
 public:
  /// points      must outlive the profile
  /// half_angle  H, if given
  CosineProfile(const std::vector<ConePoint>& points, std::optional<double> half_angle);

  ConeBox root() const { return {{0, 0}, {1, 0}}; }
  std::optional<ConeParameters> start(const ConeBox& box) const;
  double objective(const ConeParameters& parameters) const;
  double bound(const ConeBox& box, double start_objective) const;
  /// The candidate's parameters are the exponent and 0.
  ConeCandidate descend(const ConeParameters& start, std::size_t& iterations) const;

  /// The number of points inside an angle.
  std::size_t lit_within(double angle) const;
  /// The smallest number of lit points, at least `least_lit` and at most the best one for the exponent, whose objective
  /// is within a limit.
  std::optional<std::size_t> first_cut(double exponent, std::size_t least_lit, double limit) const;

 private:
  bool is_exponent_seen(std::size_t lit) const { return lit > 0 && points_[lit - 1].cosine < 1; }
  double exponent_of(double parameter) const { return (1 - parameter) / (parameter * fall_); }  // infinity at 0
  struct Cut {
    std::size_t lit;
    double loss;
  };

  /// The best number of lit points, and the loss of all points with it.
  ///
  /// lit_loss_of  loss of a point that is lit
  /// loss_of      loss of all points, given the lit points' loss and number
  template <typename Loss, typename TotalLoss>
  Cut best_cut(const Loss& lit_loss_of, const TotalLoss& loss_of) const;
  template <typename Loss>
  Cut best_cut(const Loss& lit_loss_of) const;
  Cut best_cut_at(double exponent) const;
  /// cos^S of the first points, kept by objective().
  std::span<const double> kept_powers(double exponent) const;

  const std::vector<ConePoint>& points_;
  std::vector<std::size_t> cuts_;  // possible numbers of lit points, increasing
  std::vector<double> own_exponents_;
  std::vector<double> falls_;  // -ln cos of each point; NaN beyond 90 degrees
  /// cos^S of the first points, by S, from earlier calls of objective(): each S later bounds two boxes.
  mutable std::unordered_map<double, std::vector<double>> powers_;
  std::vector<double> dark_losses_;  // sums over all points from each point on, then 0
  double fall_ = 1;
};

}  // namespace litfog
