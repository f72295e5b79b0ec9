// SPDX-License-Identifier: Apache-2.0
#include "fit/falloff.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cassert>
#include <limits>

#include "fit/branch_and_bound.h"

// The proof. With D_i(q) = q0 + q1 x_i + q2 x_i^2 = v_i . q the objective is
//
//     F(q) = sum_i f_i(D_i(q)),    f_i(D) = w_i loss(ln max(1, D) - y_i).
//
// D rises with the range, so the samples that the clamp holds at 1 are the first k, for some k. For each k they cost
// the constant sum_{i<k} w_i loss(y_i), and the clamp can be dropped from the other terms: they are convex in D up to
// D = e^(y_i + limit) and concave from there (Loss::convex_limit). Only a sample with y_i = 0 keeps the clamp and is
// never held: its term is 0 up to D = 1 and convex from there on.
//
// Coefficients better than the best known F* have f_i(D_i) < F* for each i alone, that is
// |ln D_i - y_i| < loss^-1(F* / w_i). These bounds on each D shrink a box B of coefficients. On what is left:
//
// 1. Term by term. With lines a_i + b_i D <= f_i(D) over the D_i of the box (a tangent to the convex part that stays
//    below the term up to the end of the box, or the chord),
//
//        F(q) >= sum_i a_i + min_{q in B} sum_i b_i D_i(q),
//
//    a linear function's minimum on the box, where it meets the end.
// 2. All terms together, about any point p. With r_i = D_i(p) and curvatures c_i <= h_i(D) over the D_i of the box,
//    where
//
//        f_i(D) = f_i(r_i) + f_i'(r_i) (D - r_i) + 1/2 h_i(D) (D - r_i)^2,
//
//    and with K = sum_i c_i v_i v_i^T,
//
//        F(q) >= F(p) + grad F(p) . (q - p) + 1/2 (q - p)^T K (q - p)
//             >= F(p) + min_{q in B} grad F(p) . (q - p) + 3/2 min(0, lambda_min(R K R)),
//
//    R being the diagonal matrix of the largest |q_j - p_j| in the box, so that |R^-1 (q - p)|^2 <= 3. Near a minimum
//    lambda_min is positive whatever the single terms are.
//
//    h(D) = 2 int_0^1 (1 - t) f''(r + t (D - r)) dt is a mean of f'' from r to D and so nowhere below its least value
//    there. Of plain squares, f'' = 2 w (1 - ln D + y) / D^2 falls up to ln D = y + 3/2 and rises from there. So
//    (D - r)^3 h'(D) = 2 int_r^D (D - s) (s - r) f'''(s) ds changes its sign at most once as D leaves r, and h falls
//    and then rises: in an interval it is least at the high end if it falls there, at the low end if it rises there.
//
// The first is taken at the middle of the box, and both at a reference, which is a minimum: if nothing bends down
// between it and the box, the whole box is ruled out at once. (About the middle the second closes one box in a hundred,
// for a fourth of the time.) The reference is the best known minimum; if that leaves boxes of some k open, it becomes
// the minimum with those k samples held.

namespace litfog {
namespace {

constexpr double kGap = 1e-7;
constexpr double kRounding = 1e-13;  ///< by which bounds on D are widened
/// Terms bounded before the search gives up, about a second; and a box's own work, counted in terms.
constexpr std::size_t kMaxEffort = 5'000'000;
constexpr std::size_t kBoxEffort = 10;

/// Below this D a dark sample's term counts as its value at 0, without a slope.
constexpr double kMinSmooth = 1e-6;

/// Steps from the reference, as fractions of its D, below which h loses digits: from here on it has twelve.
constexpr double kMinStep = 0.1;

/// A term with a larger D has a curvature, about 1 / D^2, that may underflow.
constexpr double kMaxCurved = 1e150;

/// Relative tolerance of the objective for a reference that is not a minimum: its slope hardly weakens the bounds.
constexpr double kReferenceTolerance = 1e-8;

/// A number of held samples gets a descent of its own when it has more open boxes than this: it costs as much.
constexpr std::size_t kPatience = 8;

/// Above each D and each coefficient of a minimum: a sample or the end holds each term at 1e100 or less, and no other
/// range is more than 1e60 times as far (attenuation_fit.cpp). Infinity would not do: at x = 0 its product is NaN.
constexpr double kMost = 1e300;

struct Interval {
  double low = 0;
  double high = kMost;

  Interval with(double x) const { return {std::min(low, x), std::max(high, x)}; }
};

using Box = std::array<Interval, 3>;

Coefficients low_corner(const Box& box) { return {box[0].low, box[1].low, box[2].low}; }
Coefficients high_corner(const Box& box) { return {box[0].high, box[1].high, box[2].high}; }

/// value + slope D, a lower bound of a term.
struct Line {
  double value;
  double slope;
};

/// A linear function of the coefficients.
struct Plane {
  double value = 0;
  Coefficients slope{};

  void add(const Line& line, double x) {
    value += line.value;
    slope[0] += line.slope;
    slope[1] += line.slope * x;
    slope[2] += line.slope * x * x;
  }
};

using Matrix = Eigen::Matrix3d;

/// A minimum below this improves on the best known by more than the open gap and rounding.
double wanted_objective(const Falloff& falloff, const FalloffMinimum& best) {
  return best.objective - std::max(kGap * best.objective, falloff.negligible());
}

/// The search with the first samples held by the clamp: a problem for branch_and_bound.
class HeldSearch {
 public:
  /// held_cost  total cost of the held samples
  HeldSearch(const Falloff& falloff, std::size_t held_count, double held_cost, FalloffMinimum& best)
      : falloff_(falloff), held_count_(held_count), held_cost_(held_cost), best_(best) {
    for (const auto& [x, y, weight] : falloff.samples)
      terms_.push_back({x, Powers(x), double(y), weight, {}, 1, 0, {}});
    ranges_.resize(terms_.size());
    restart();
  }

  Box root() const {
    Box box;
    if (falloff_.constant) box[0] = {*falloff_.constant, *falloff_.constant};
    if (falloff_.end && !falloff_.constant) box[0].high = falloff_.largest_constant();
    return box;
  }

  bool is_closed(double bound) const { return bound > wanted_objective(falloff_, best_); }

  /// Shrinks the box until each D is within its bounds, in one pass: a second pass is left to the next box.
  bool contract(Box& box) const {
    for (const Term& term : terms_) {
      if (!contract(box, term.powers, term.d)) return false;
    }
    if (!falloff_.end) return true;
    const double top = double(falloff_.end->top);
    return contract(box, Powers(falloff_.end->x), {top * (1 - kRounding), top * (1 + kRounding)});
  }

  double examine(const Box& box) {
    try_inside(box);
    double bound = held_cost_ + lower_bound(box);
    if (!is_closed(bound) && !has_own_reference_ && ++boxes_left_ > kPatience) {
      has_own_reference_ = true;
      refer_to_held_minimum();
      bound = std::max(bound, held_cost_ + lower_bound(box));
    }
    assert(is_below_objective(box, bound));
    return bound;
  }

  /// Splits the box along the coefficient that changes some D the most, relative to its size; below 1 the clamp hides
  /// all changes.
  std::optional<std::array<Box, 2>> split(const Box& box) const {
    const Coefficients point = middle(box);
    Coefficients change{};
    for (const Term& term : terms_) {
      const double inverse = 1 / std::max(1.0, denominator(point, term.x));
      change[0] = std::max(change[0], inverse);
      change[1] = std::max(change[1], inverse * term.x);
      change[2] = std::max(change[2], inverse * term.x * term.x);
    }
    for (std::size_t j = 0; j < 3; ++j) change[j] *= box[j].high - box[j].low;
    const auto widest = std::size_t(std::max_element(change.begin(), change.end()) - change.begin());
    const auto [low, high] = box[widest];
    // Bounds may be decades apart.
    double at = (low + high) / 2;
    if (low > 0 && high > 8 * low) at = std::sqrt(low) * std::sqrt(high);
    if (low == 0) at = high / 8;
    if (!(at > low && at < high)) return std::nullopt;  // neighbouring floating-point numbers
    std::array<Box, 2> halves{box, box};
    halves[0][widest].high = halves[1][widest].low = at;
    return halves;
  }

 private:
  /// 1, x, x^2 and their inverses.
  struct Powers {
    Coefficients power, inverse;

    explicit Powers(double x) : power{1, x, x * x}, inverse{1, 1 / x, 1 / x / x} {}
  };

  struct Term {
    double x;
    Powers powers;
    double y, weight;
    Interval d;                           ///< in which the objective can be better than the best known
    double reference_d, log_reference_d;  ///< D of the reference
    Line tangent;                         ///< there; of a held sample, a line that is at most 0 up to D = 1
  };

  /// The range of a term's D in a box.
  struct Range {
    Interval d, log_d;
  };

  void try_inside(const Box& box) {
    const Coefficients start = middle(box);
    if (!(falloff_.objective(start) < wanted_objective(falloff_, best_))) return;
    FalloffMinimum better = descend(falloff_, start);
    better.iterations += best_.iterations;
    if (!(better.objective < wanted_objective(falloff_, best_))) return;
    best_ = better;
    restart();
  }

  bool is_held(std::size_t i) const { return i < held_count_ && terms_[i].y > 0; }

  double cost(const Term& term, double log_d) const { return term.weight * falloff_.loss.value(log_d - term.y); }
  /// The term's minimum for D in a range.
  double least_cost(const Term& term, const Range& range) const {
    const double log_d = std::clamp(term.y, range.log_d.low, range.log_d.high);
    return cost(term, term.y == 0 ? std::max(0.0, log_d) : log_d);
  }
  Line tangent(const Term& term, double d, double log_d) const {
    if (term.y == 0 && d <= 1) return {0, 0};
    const double slope = term.weight * falloff_.loss.slope(log_d - term.y) / d;
    return {cost(term, log_d) - slope * d, slope};
  }
  bool is_convex_to(const Term& term, double log_d) const { return log_d <= term.y + falloff_.loss.convex_limit(); }

  /// Recomputes all that depends on the best known minimum.
  void restart() {
    bound_denominators();
    refer_to(best_.coefficients);
    has_own_reference_ = held_count_ == 0;
  }

  /// Bounds of each D for an objective below the best known.
  void bound_denominators() {
    const double spare = std::max(0.0, best_.objective + falloff_.negligible() - held_cost_);
    for (std::size_t i = 0; i < terms_.size(); ++i) {
      Term& term = terms_[i];
      const double reach = falloff_.loss.residual(spare / term.weight);
      term.d = {term.y == 0 ? 0 : std::max(1.0, std::exp(term.y - reach)), std::min(std::exp(term.y + reach), kMost)};
      if (is_held(i)) term.d = {0, 1};
      term.d.low *= 1 - kRounding;
      term.d.high *= 1 + kRounding;
    }
  }

  void refer_to(const Coefficients& reference) {
    reference_ = reference;
    is_reference_smooth_ = true;
    for (std::size_t i = 0; i < terms_.size(); ++i) {
      Term& term = terms_[i];
      const double d = denominator(reference, term.x);
      if (!is_held(i) && term.y > 0 && !(d > kMinSmooth)) is_reference_smooth_ = false;
      term.reference_d = std::max(d, kMinSmooth);
      term.log_reference_d = std::log(term.reference_d);
      term.tangent = tangent(term, term.reference_d, term.log_reference_d);
      if (is_held(i)) set_slope(term, d > 1 ? term.tangent.slope : 0);
    }
  }

  static void set_slope(Term& term, double slope) {
    slope = std::max(0.0, slope);
    term.tangent = {-slope, slope};
  }

  /// Refers to the minimum with the first samples held: without minding their D where that is at most 1, else with D =
  /// 1 at the last of them, which then holds it.
  void refer_to_held_minimum() {
    std::size_t last = held_count_ - 1;
    Falloff rest = falloff_;
    rest.is_clamped = false;
    std::erase_if(rest.samples,
                  [&](const Falloff::Sample& sample) { return sample.y > 0 && sample.x <= terms_[last].x; });
    if (rest.samples.empty()) return;
    Coefficients q = approach(rest, best_.coefficients, kReferenceTolerance).coefficients;
    const double x = terms_[last].x, d = denominator(q, x), given = falloff_.constant.value_or(0);
    if (d <= 1 || falloff_.end || given >= 1) return refer_to(q);
    const double factor = (1 - given) / (d - given);
    for (std::size_t j = falloff_.constant ? 1 : 0; j < 3; ++j) q[j] *= factor;
    if (x > 0) {
      rest.end = {x, 1};
    } else {
      rest.constant = 1;
    }
    refer_to(approach(rest, q, kReferenceTolerance).coefficients);
    Plane all;
    for (std::size_t i = 0; i < terms_.size(); ++i) {
      if (!is_held(i)) all.add(terms_[i].tangent, terms_[i].x);
    }
    const Coefficients power{1, x, x * x};
    std::size_t largest = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      if (reference_[j] * power[j] > reference_[largest] * power[largest]) largest = j;
    }
    set_slope(terms_[last], -all.slope[largest] / power[largest]);
  }

  static bool contract(Box& box, const Powers& x, const Interval& d) {
    for (std::size_t j = 0; j < 3; ++j) {
      if (!(x.power[j] > 0)) continue;
      double low = 0, high = 0;  // sums of the others
      for (std::size_t k = 0; k < 3; ++k) {
        if (k == j || !(x.power[k] > 0)) continue;
        low += x.power[k] * box[k].low;
        high += x.power[k] * box[k].high;
      }
      Interval& q = box[j];
      q.high = std::min(q.high, (d.high - low) * x.inverse[j]);
      q.low = std::max(q.low, (d.low - high) * x.inverse[j]);
      if (!(q.low <= q.high)) {
        if (!(q.low <= q.high * (1 + 4 * kRounding))) return false;
        q.low = q.high;  // GCOV_EXCL_LINE: by rounding alone
      }
    }
    return true;
  }

  /// A point in the box on the end's plane.
  Coefficients middle(const Box& box) const {
    double fraction = 0.5;
    if (falloff_.end) {
      const Coefficients low{box[0].low, box[1].low, box[2].low};
      const Coefficients high{box[0].high, box[1].high, box[2].high};
      const double least = denominator(low, falloff_.end->x), most = denominator(high, falloff_.end->x);
      fraction = most > least ? std::clamp((double(falloff_.end->top) - least) / (most - least), 0.0, 1.0) : 0;
    }
    Coefficients point;
    for (std::size_t j = 0; j < 3; ++j) point[j] = box[j].low + fraction * (box[j].high - box[j].low);
    return point;
  }

  /// Lower bound of the objective minus the held samples' cost.
  double lower_bound(const Box& box) {
    const Coefficients low = low_corner(box), high = high_corner(box), point = middle(box);
    for (std::size_t i = 0; i < terms_.size(); ++i) {
      if (is_held(i)) continue;
      const Term& term = terms_[i];
      const double least = std::max(denominator(low, term.x), term.d.low);
      const double most = std::max(least, std::min(denominator(high, term.x), term.d.high));
      ranges_[i] = {{least, most}, {std::log(least), std::log(most)}};
    }
    // The cheap ones first: one that closes the box is enough.
    double bound = 0;
    const auto is_enough = [&](double next) {
      bound = std::max(bound, next);
      return is_closed(held_cost_ + bound);
    };
    if (is_enough(level_bound()) || is_enough(reference_line_bound(box)) || is_enough(line_bound(box, point))) {
      return bound;
    }
    if (!is_convex()) is_enough(reference_curvature_bound(box));
    return bound;
  }

  /// Whether a bound is below the objective, but for the open gap, at the box's middle and two of its corners. Nothing
  /// is known of one that misses the end, or where a D is outside its interval.
  bool is_below_objective(const Box& box, double bound) const {
    return std::ranges::all_of(std::array{low_corner(box), middle(box), high_corner(box)}, [&](const Coefficients& q) {
      Box point{{{q[0], q[0]}, {q[1], q[1]}, {q[2], q[2]}}};
      if (!contract(point)) return true;
      const double objective = falloff_.objective(q);
      return !(bound > objective + kGap * (objective + best_.objective) + falloff_.negligible());
    });
  }

  /// Whether all terms are convex in the box and from there to the reference. Then the lines are tangents, and
  /// curvature cannot lower the bound.
  bool is_convex() const {
    for (std::size_t i = 0; i < terms_.size(); ++i) {
      const double most = std::max(ranges_[i].log_d.high, terms_[i].log_reference_d);
      if (!is_held(i) && !is_convex_to(terms_[i], most)) return false;
    }
    return true;
  }

  /// Inequality 1 with each term's minimum.
  double level_bound() const {
    double level = 0;
    for (std::size_t i = 0; i < terms_.size(); ++i) {
      if (!is_held(i)) level += least_cost(terms_[i], ranges_[i]);
    }
    return level;
  }

  /// Inequality 1 with tangents at a point in the box, chords and minima.
  double line_bound(const Box& box, const Coefficients& point) const {
    Plane sum;
    for (std::size_t i = 0; i < terms_.size(); ++i) {
      if (is_held(i)) continue;
      const Term& term = terms_[i];
      sum.add(line_below(term, ranges_[i], std::max(denominator(point, term.x), kMinSmooth)), term.x);
    }
    return sum.value + smallest_of(sum.slope, box);
  }

  /// Inequality 1 with tangents at the reference, chords and minima.
  double reference_line_bound(const Box& box) const {
    Plane sum;
    for (std::size_t i = 0; i < terms_.size(); ++i) {
      const Term& term = terms_[i];
      const bool is_convex = is_held(i) || is_convex_to(term, std::max(ranges_[i].log_d.high, term.log_reference_d));
      sum.add(is_convex ? term.tangent : line_below(term, ranges_[i], term.reference_d), term.x);
    }
    return sum.value + smallest_of(sum.slope, box);
  }

  /// Inequality 2 about the reference; 0 if a term has no tangent there, or a D is above kMaxCurved.
  double reference_curvature_bound(const Box& box) const {
    if (!is_reference_smooth_) return 0;
    Plane tangents;
    Matrix curvature = Matrix::Zero();
    for (std::size_t i = 0; i < terms_.size(); ++i) {
      const Term& term = terms_[i];
      tangents.add(term.tangent, term.x);
      if (is_held(i)) continue;
      if (ranges_[i].d.with(term.reference_d).high > kMaxCurved) return 0;
      add_square(curvature, least_curvature(term, ranges_[i]), term.x);
    }
    return tangents.value + smallest_of(tangents.slope, box) + smallest_bend(curvature, reference_, box);
  }

  /// A line below a term in its range: the tangent at a point, at its low end, or the chord. A tangent to the convex
  /// part is below the whole term if it is so at the high end; if the tangent at the low end is not, the chord is.
  Line line_below(const Term& term, const Range& range, double point) const {
    const Interval d = range.d, log_d = range.log_d;
    const bool is_convex = is_convex_to(term, log_d.high);
    const double at_high = cost(term, term.y == 0 ? std::max(0.0, log_d.high) : log_d.high);
    const auto is_below = [&](const Line& line) { return is_convex || line.value + line.slope * d.high <= at_high; };
    const double at = std::clamp(point, d.low, d.high), log_at = std::log(at);
    if (is_convex_to(term, log_at)) {
      const Line line = tangent(term, at, log_at);
      if (is_below(line)) return line;
    }
    if (is_convex_to(term, log_d.low)) {
      const Line line = tangent(term, d.low, log_d.low);
      if (is_below(line)) return line;
    }
    const double at_low = cost(term, log_d.low);
    const double slope = d.high > d.low ? (at_high - at_low) / (d.high - d.low) : 0;
    return {at_low - slope * d.low, slope};
  }

  /// A lower bound of h of inequality 2, about the reference, for a term's D in a range.
  double least_curvature(const Term& term, const Range& range) const {
    const double r = term.reference_d, z = term.log_reference_d - term.y;
    for (const bool is_high : {true, false}) {
      if (!falloff_.loss.is_plain() || term.y == 0) break;
      const double log_step = (is_high ? range.log_d.high : range.log_d.low) - term.log_reference_d;
      const double step = (is_high ? range.d.high : range.d.low) / r - 1;
      if (std::abs(step) < kMinStep) continue;
      const double above_tangent = log_step * log_step - 2 * z * (step - log_step);           // per weight
      const double rise = step * (((z + log_step) / (1 + step) - z) * step - above_tangent);  // has the sign of h'
      if (is_high ? rise <= 0 : rise >= 0) return 2 * term.weight * above_tangent / (step * r * (step * r));
    }
    return least_second_derivative(term, range.d.with(r), range.log_d.with(term.log_reference_d));
  }

  /// A lower bound of a term's second derivative in D.
  double least_second_derivative(const Term& term, const Interval& d, const Interval& log_d) const {
    const bool is_level = term.y == 0 && d.low < 1;
    const double z_low = is_level ? 0 : log_d.low - term.y;
    const double z_high = is_level ? std::max(0.0, log_d.high) : log_d.high - term.y;
    const double factor =
        std::min(falloff_.loss.curvature(z_low), falloff_.loss.curvature(z_high)) - falloff_.loss.slope(z_high);
    const double nearest = factor >= 0 ? d.high : is_level ? 1 : d.low;
    const double curvature = term.weight * factor / (nearest * nearest);
    return is_level ? std::min(0.0, curvature) : curvature;
  }

  static void add_square(Matrix& curvature, double weight, double x) {
    const Eigen::Vector3d power(1, x, x * x);
    curvature += weight * power * power.transpose();
  }

  /// The smallest value on the box of the quadratic form with this curvature about a point; not above 0.
  double smallest_bend(const Matrix& curvature, const Coefficients& point, const Box& box) const {
    Eigen::Vector3d reach;
    for (std::size_t j = 0; j < 3; ++j) {
      reach[Eigen::Index(j)] = std::max({0.0, box[j].high - point[j], point[j] - box[j].low});
    }
    Matrix scaled = reach.asDiagonal() * curvature * reach.asDiagonal();
    if (falloff_.end) {  // across the plane of the end nothing moves
      const double e = falloff_.end->x;
      const Eigen::Vector3d across = reach.cwiseProduct(Eigen::Vector3d(1, e, e * e));
      if (across.squaredNorm() > 0) {
        scaled += 100 * scaled.cwiseAbs().maxCoeff() / across.squaredNorm() * across * across.transpose();
      }
    }
    if (!scaled.allFinite()) return -std::numeric_limits<double>::infinity();
    const double smallest = Eigen::SelfAdjointEigenSolver<Matrix>(scaled, Eigen::EigenvaluesOnly).eigenvalues()[0] -
                            1e-15 * scaled.cwiseAbs().maxCoeff();
    return 1.5 * std::min(0.0, smallest);  // half, times the squared length of at most 3
  }

  /// The smallest value of a linear function on the box, on the end's plane.
  double smallest_of(const Coefficients& slope, const Box& box) const {
    if (!falloff_.end) {
      double value = 0;
      for (std::size_t j = 0; j < 3; ++j) value += slope[j] * (slope[j] > 0 ? box[j].low : box[j].high);
      return value;
    }
    // From the low corner up to the end, first along the coefficient of least cost per rise there.
    const double e = falloff_.end->x;
    const Coefficients power{1, e, e * e};
    std::array<std::size_t, 3> order{0, 1, 2};
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return slope[a] * power[b] < slope[b] * power[a]; });
    double value = 0, rest = double(falloff_.end->top);
    for (std::size_t j = 0; j < 3; ++j) {
      value += slope[j] * box[j].low;
      rest -= power[j] * box[j].low;
    }
    for (const std::size_t j : order) {
      const double part = std::clamp(rest, 0.0, power[j] * (box[j].high - box[j].low));
      value += slope[j] * part / power[j];
      rest -= part;
    }
    return value;
  }

  const Falloff& falloff_;
  std::size_t held_count_;
  double held_cost_;
  FalloffMinimum& best_;
  std::vector<Term> terms_;
  std::vector<Range> ranges_;  ///< one per term that is not held, in the current box
  Coefficients reference_{};
  bool is_reference_smooth_ = false;  ///< each term has a tangent at the reference
  bool has_own_reference_ = false;    ///< other than the best known minimum
  std::size_t boxes_left_ = 0;        ///< open after the first bound
};

}  // namespace

FalloffSearch search(const Falloff& falloff, const FalloffMinimum& local) {
  const auto& samples = falloff.samples;
  FalloffSearch result{local, 0, true};
  const std::size_t max_boxes = kMaxEffort / (samples.size() + kBoxEffort);
  double held_cost = 0;
  for (std::size_t k = 0; result.is_proven && held_cost <= wanted_objective(falloff, result.minimum); ++k) {
    HeldSearch problem(falloff, k, held_cost, result.minimum);
    const auto [bound, boxes, is_proven] =
        branch_and_bound<Evaluation::lazy>(problem, max_boxes - std::min(max_boxes, result.boxes));
    result.boxes += boxes;
    result.is_proven = is_proven;
    while (k < samples.size() && samples[k].y == 0) ++k;
    if (k >= samples.size()) break;
    held_cost += samples[k].weight * falloff.loss.value(double(samples[k].y));
  }
  return result;
}

}  // namespace litfog
