// SPDX-License-Identifier: Apache-2.0
#include "fit/smoothstep_profile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

#include "fit/least_squares.h"
#include "litfog/formulas.h"

namespace litfog {
namespace {

/// The error is a difference of fractions, as in CosineResidual. The formula uses only differences of cosines, so it
/// gets negative versines, which keep their digits near the axis.
struct SmoothstepResidual {
  const ConePoint& point;

  template <typename T>
  T operator()(const T& inner, const T& outer) const {
    return std::sqrt(point.weight) *
           (formulas::smoothstep_cone(T(-point.versine), T(-inner), T(-outer)) - point.fraction);
  }
};

double smoothstep_at(const ConePoint& point, const ConeParameters& parameters) {
  // A cone that ends here leaves the point dark, also in the limit; every cone lights the axis.
  if (point.versine >= parameters[1] && point.versine > 0) return 0;
  return formulas::smoothstep_cone(-point.versine, -parameters[0], -parameters[1]);
}

double smoothstep(double t) { return t * t * (3 - 2 * t); }

/// A range that holds a derivative.
struct Slope {
  double least = 0;
  double most = 0;
};

}  // namespace

SmoothstepProfile::SmoothstepProfile(const std::vector<ConePoint>& points, std::optional<double> outer)
    : points_(points), full_losses_{0} {
  if (outer) outer_ = versine(*outer);
  for (const ConePoint& point : points) full_losses_.push_back(full_losses_.back() + point.loss(1));
  dark_begin_ = points.end();
  while (dark_begin_ != points.begin() && dark_begin_[-1].fraction == 0) --dark_begin_;
}

ConeBox SmoothstepProfile::root() const {
  const double farthest = outer_ ? *outer_ : points_.back().versine;
  return {{0, outer_ ? *outer_ : 0}, {farthest, outer_ ? *outer_ : 2}};
}

std::optional<ConeParameters> SmoothstepProfile::start(const ConeBox& box) const {
  if (!(box.least[0] < box.most[1])) return std::nullopt;
  const ConeParameters middle{(box.least[0] + box.most[0]) / 2, (box.least[1] + box.most[1]) / 2};
  return middle[0] < middle[1] ? middle : ConeParameters{box.least[0], box.most[1]};
}

SmoothstepProfile::Point SmoothstepProfile::full_end(const ConeParameters& parameters) const {
  const double inner = parameters[0], outer = parameters[1];
  return std::partition_point(points_.begin(), points_.end(), [inner, outer](const ConePoint& point) {
    return point.versine == 0 || (point.versine <= inner && point.versine < outer);
  });
}

SmoothstepProfile::Point SmoothstepProfile::dark_from(double outer) const {
  return std::partition_point(points_.begin(), points_.end(),
                              [outer](const ConePoint& point) { return point.versine == 0 || point.versine < outer; });
}

template <typename Loss>
double SmoothstepProfile::sum_losses(Point full, Point dark, const Loss& loss) const {
  double sum = full_losses_[std::size_t(full - points_.begin())];
  for (Point point = full; point < dark; ++point) sum += loss(*point);
  for (Point point = dark; point < dark_begin_; ++point) sum += point->loss(0);
  return sum;
}

double SmoothstepProfile::objective(const ConeParameters& parameters) const {
  return sum_losses(full_end(parameters), dark_from(parameters[1]),
                    [&](const ConePoint& point) { return point.loss(smoothstep_at(point, parameters)); });
}

double SmoothstepProfile::bound(const ConeBox& box, double start_objective) const {
  // If the ranges overlap, a step is the limit of the cones.
  const ConeParameters least{box.least[0], std::max(box.least[0], box.least[1])};
  const ConeParameters most{std::min(box.most[0], box.most[1]), box.most[1]};
  const double sum = sum_losses(full_end(least), dark_from(most[1]), [&](const ConePoint& point) {
    return point.loss(smoothstep_at(point, least), smoothstep_at(point, most));
  });
  return std::max(sum, mean_value_bound(box, start_objective));
}

/// The objective F is at least F(middle) - sum over the parameters of max |dF/dp| over the box times half its width.
/// Near a minimum this bound misses F by the square of the width; a bound by each point alone misses it by the width.
///
/// With x a point's versine, t = (outer - x) / (outer - inner) in [0, 1] and s = t^2 (3 - 2 t) its cone,
///     ds/dinner = 6 t^2 (1 - t) / (outer - inner),  ds/douter = 6 t (1 - t)^2 / (outer - inner),
/// both >= 0. A box that holds steps has no such slopes and is bounded by 0.
double SmoothstepProfile::mean_value_bound(const ConeBox& box, double middle_objective) const {
  const double least_width = box.least[1] - box.most[0], most_width = box.most[1] - box.least[0];
  if (!(least_width > 0)) return 0;
  const auto t_at = [](double versine, const ConeParameters& parameters) {
    return std::clamp((parameters[1] - versine) / (parameters[1] - parameters[0]), 0.0, 1.0);
  };
  constexpr double kSteepest = 8.0 / 9;  // largest value of 6 t^2 (1 - t), at 2/3, and of 6 t (1 - t)^2, at 1/3
  constexpr std::array kSteepestAt{2.0 / 3, 1.0 / 3};
  std::array<Slope, 2> slopes;  // slopes of F
  const Point dark = dark_from(box.most[1]);
  for (Point point = full_end(box.least); point < dark; ++point) {  // all others are flat in the whole box
    const double low = t_at(point->versine, box.least), high = t_at(point->versine, box.most);
    if (low == 1 || high == 0) continue;
    const double least_error = smoothstep(low) - point->fraction, most_error = smoothstep(high) - point->fraction;
    const double low_factor = 6 * low * (1 - low), high_factor = 6 * high * (1 - high);
    for (std::size_t j = 0; j < 2; ++j) {
      const double at_low = low_factor * (j == 0 ? low : 1 - low), at_high = high_factor * (j == 0 ? high : 1 - high);
      const double flat = std::min(at_low, at_high), steep = std::max(at_low, at_high);
      const bool holds_steepest = low < kSteepestAt[j] && high > kSteepestAt[j];
      const double least = flat / most_width, most = (holds_steepest ? kSteepest : steep) / least_width;
      slopes[j].least += 2 * point->weight * least_error * (least_error < 0 ? most : least);
      slopes[j].most += 2 * point->weight * most_error * (most_error < 0 ? least : most);
    }
  }
  double bound = middle_objective;
  for (std::size_t j = 0; j < 2; ++j) {
    bound -= std::max(-slopes[j].least, slopes[j].most) * (box.most[j] - box.least[j]) / 2;
  }
  return bound;
}

ConeCandidate SmoothstepProfile::descend(const ConeParameters& start, std::size_t& iterations) const {
  const auto edge_given = [this](const auto* inner, auto* residuals) {
    const std::decay_t<decltype(*inner)> outer(*outer_);
    for (const ConePoint& point : points_) *residuals++ = SmoothstepResidual{point}(*inner, outer);
  };
  const auto edge_free = [this](const auto* edge, auto* residuals) {
    for (const ConePoint& point : points_) *residuals++ = SmoothstepResidual{point}(edge[0], edge[1]);
  };
  const std::size_t count = outer_ ? 1 : 2;
  const LeastSquaresFit fit =
      fit_least_squares({.residual_count = points_.size(),
                         .evaluate = outer_ ? differentiate<1>(edge_given) : differentiate<2>(edge_free),
                         .lower = std::vector<double>(count, 0),
                         .upper = std::vector<double>(count, 2)},
                        {start.data(), count}, Descent::one);
  ConeCandidate candidate;
  candidate.parameters[1] = outer_ ? *outer_ : fit.parameters[1];
  candidate.parameters[0] = std::min(fit.parameters[0], candidate.parameters[1] * (1 - kNarrowestEdge));
  candidate.objective = objective(candidate.parameters);
  candidate.kkt_residual = fit.gradient;
  candidate.covariance = fit.covariance;
  iterations += fit.iterations;
  return candidate;
}

ConeParameters SmoothstepProfile::softest(const ConeParameters& parameters, double exact, bool& is_identified) const {
  double full = 0;
  double dark = outer_ ? *outer_ : 2;
  double inside = 0;
  double part = 0;        // fraction of the edge beyond `inside`, linear in the versine
  std::size_t count = 0;  // number of different angles
  for (const ConePoint& point : points_) {
    const double cone = smoothstep_at(point, parameters);
    constexpr double kEnd = 1e-9;  // a descent ends so near a full or dark point, not on it
    if (cone > 1 - kEnd) {
      full = point.versine;
    } else if (cone < kEnd) {
      dark = std::min(dark, point.versine);
    } else if (count == 0 || point.versine > inside) {
      inside = point.versine;
      part = (parameters[1] - inside) / (parameters[1] - parameters[0]);
      ++count;
    }
  }
  is_identified = count >= (outer_ ? 1u : 2u);
  if (is_identified) return parameters;
  ConeParameters result{full, dark};
  if (count == 1) {  // outer - inside = part * (outer - inner)
    const double outer = (inside - part * full) / (1 - part);
    result = outer <= dark ? ConeParameters{full, outer} : ConeParameters{(inside - (1 - part) * dark) / part, dark};
  }
  return objective(result) <= std::max(objective(parameters) * (1 + 1e-12), exact) ? result : parameters;
}

}  // namespace litfog
