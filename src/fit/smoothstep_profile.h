// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "fit/cone_point.h"
#include "fit/cone_search.h"

// Internal.

namespace litfog {

/// smoothstep(cos outer, cos inner, cos u), as a profile of ConeSearch. Parameters are the versines of inner and outer.
class SmoothstepProfile {
 public:
  /// points  must outlive the profile
  /// outer   radians, if given
  SmoothstepProfile(const std::vector<ConePoint>& points, std::optional<double> outer);

  ConeBox root() const;
  /// The box's centre or, near the diagonal, the corner that is a cone.
  std::optional<ConeParameters> start(const ConeBox& box) const;
  double objective(const ConeParameters& parameters) const;
  double bound(const ConeBox& box, double start_objective) const;
  ConeCandidate descend(const ConeParameters& start, std::size_t& iterations) const;

  /// The softest of all edges that give the points the same fractions, if the edge has fewer points than parameters.
  ConeParameters softest(const ConeParameters& parameters, double exact, bool& is_identified) const;

 private:
  using Point = std::vector<ConePoint>::const_iterator;

  Point full_end(const ConeParameters& parameters) const;  ///< the end of the points at full light
  Point dark_from(double outer) const;
  /// The sum of the losses: points before `full` are at full light, lit points lose `loss`, and points from `dark` on
  /// are dark.
  template <typename Loss>
  double sum_losses(Point full, Point dark, const Loss& loss) const;
  double mean_value_bound(const ConeBox& box, double middle_objective) const;

  const std::vector<ConePoint>& points_;
  std::vector<double> full_losses_;  // sums over the points before each point, at full light
  Point dark_begin_;                 // from here to the last all points are dark
  std::optional<double> outer_;      // versine, if given
};

}  // namespace litfog
