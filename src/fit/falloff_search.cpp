// SPDX-License-Identifier: Apache-2.0
#include "fit/falloff_search.h"

#include <Eigen/Dense>
#include <algorithm>
#include <limits>
#include <queue>

// The samples that the clamp holds at 1 are the first ones, for D rises with the range: so many, then no more. For each
// such number k the objective is smooth: a constant for the k samples, and beyond them terms that are convex in D up to
// e^limit of the sample and concave from there. Whatever is better than the best known has each term alone below the
// best objective, which bounds each D, and the boxes shrink to what these bounds leave. Then linear functions of the
// coefficients bound the objective from below:
// - term by term, a tangent where the term is convex in the box, a chord where it is concave, a level where it is both;
// - all tangents together, less what the whole may bend down from them in the box (the least eigenvalue of a curvature
//   that is nowhere less), which near a minimum is nothing, whatever its terms are.
// Tangents are tried at a place in the box and at a reference, which is a minimum: where nothing bends down from there
// to the box, all of the box is ruled out at once. The reference is the best known and, where that leaves a box of some
// k, the minimum with those k samples held.
//
// A sample with attenuation 1 is never held: its term is level up to D = 1, and convex from the start.

namespace litfog {
namespace {

constexpr double kGap = 1e-7;
constexpr double kRounding = 1e-13;  ///< by which bounds on D are widened
/// Terms bounded before the search gives up, and a box's own work in terms: about a second.
constexpr std::size_t kLargestEffort = 5'000'000;
constexpr std::size_t kBoxEffort = 10;

/// Below this D a dark sample's term is taken for what it is at 0, without a slope.
constexpr double kLeastSmooth = 1e-6;

/// Boxes left before a number of held samples is worth a descent of its own, which costs as much as so many.
constexpr std::size_t kPatience = 30;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Interval {
  double low = 0;
  double high = kInfinity;

  Interval with(double x) const { return {std::min(low, x), std::max(high, x)}; }
};

struct Box {
  std::array<Interval, 3> q;
  double bound = 0;  ///< of the objective, from below

  friend bool operator<(const Box& a, const Box& b) { return a.bound > b.bound; }  // the most promising first
};

/// value + slope D, nowhere above a term.
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

class Search {
 public:
  Search(const Falloff& falloff, const FalloffMinimum& local) : falloff_(falloff) {
    result_.minimum = local;
    for (const auto& [x, y, weight] : falloff.samples) terms_.push_back({x, double(y), weight, {}, 1, 0, {}});
    rows_ = terms_.size();
  }

  FalloffSearch run() {
    result_.is_proven = true;
    double held = 0;
    for (std::size_t k = 0; result_.is_proven; ++k) {
      if (held > target()) break;
      search_with_held(k, held);
      while (k < rows_ && terms_[k].y == 0) ++k;
      if (k >= rows_) break;
      held += terms_[k].weight * falloff_.loss.value(terms_[k].y);
    }
    return result_;
  }

 private:
  struct Term {
    double x, y, weight;
    Interval d;                           ///< where the objective can be better than the best known
    double reference_d, log_reference_d;  ///< D of the reference
    Line tangent;                         ///< there; of a held sample, a line that is at most 0 up to D = 1
  };

  /// What a box must promise to be looked at.
  double target() const {
    return result_.minimum.objective - std::max(kGap * result_.minimum.objective, falloff_.negligible());
  }

  bool is_held(std::size_t i) const { return i < held_count_ && terms_[i].y > 0; }

  double cost(const Term& term, double log_d) const { return term.weight * falloff_.loss.value(log_d - term.y); }
  /// With the clamp of a sample with attenuation 1.
  double open_cost(const Term& term, double log_d) const {
    return cost(term, term.y == 0 ? std::max(0.0, log_d) : log_d);
  }
  Line tangent(const Term& term, double d, double log_d) const {
    if (term.y == 0 && d <= 1) return {0, 0};
    const double slope = term.weight * falloff_.loss.slope(log_d - term.y) / d;
    return {cost(term, log_d) - slope * d, slope};
  }
  bool is_convex_to(const Term& term, double log_d) const { return log_d <= term.y + falloff_.loss.convex_limit(); }

  /// Bounds of each D for an objective below the best known.
  void bound_denominators(double held) {
    const double spare = std::max(0.0, result_.minimum.objective + falloff_.negligible() - held);
    for (std::size_t i = 0; i < rows_; ++i) {
      Term& term = terms_[i];
      const double reach = falloff_.loss.residual(spare / term.weight);
      term.d = {term.y == 0 ? 0 : std::max(1.0, std::exp(term.y - reach)), std::exp(term.y + reach)};
      if (is_held(i)) term.d = {0, 1};
      term.d.low *= 1 - kRounding;
      term.d.high *= 1 + kRounding;
    }
  }

  void refer_to(const Coefficients& reference) {
    reference_ = reference;
    is_reference_smooth_ = true;
    for (std::size_t i = 0; i < rows_; ++i) {
      Term& term = terms_[i];
      const double d = denominator(reference, term.x);
      if (!is_held(i) && term.y > 0 && !(d > kLeastSmooth)) is_reference_smooth_ = false;
      term.reference_d = std::max(d, kLeastSmooth);
      term.log_reference_d = std::log(term.reference_d);
      term.tangent = tangent(term, term.reference_d, term.log_reference_d);
      if (is_held(i)) lean(term, d > 1 ? term.tangent.slope : 0);
    }
  }

  static void lean(Term& term, double slope) {
    slope = std::max(0.0, slope);
    term.tangent = {-slope, slope};
  }

  /// Refers to the minimum with the first samples held: without minding their D where that is at most 1, else with D =
  /// 1 at the last of them, on which it then leans.
  void refer_to_held_minimum() {
    std::size_t last = held_count_ - 1;
    Falloff rest = falloff_;
    rest.is_clamped = false;
    std::erase_if(rest.samples,
                  [&](const Falloff::Sample& sample) { return sample.y > 0 && sample.x <= terms_[last].x; });
    if (rest.samples.empty()) return;
    Coefficients q = descend(rest, result_.minimum.coefficients).coefficients;
    const double x = terms_[last].x, d = denominator(q, x), given = falloff_.constant.value_or(0);
    if (d <= 1 || falloff_.end || given >= 1) return refer_to(q);
    const double share = (1 - given) / (d - given);
    for (std::size_t j = falloff_.constant ? 1 : 0; j < 3; ++j) q[j] *= share;
    if (x > 0) {
      rest.end = {x, 1};
    } else {
      rest.constant = 1;
    }
    refer_to(descend(rest, q).coefficients);
    Plane all;
    for (std::size_t i = 0; i < rows_; ++i) {
      if (!is_held(i)) all.add(terms_[i].tangent, terms_[i].x);
    }
    const Coefficients power{1, x, x * x};
    std::size_t largest = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      if (reference_[j] * power[j] > reference_[largest] * power[largest]) largest = j;
    }
    lean(terms_[last], -all.slope[largest] / power[largest]);
  }

  void search_with_held(std::size_t k, double held) {
    held_count_ = k;
    bound_denominators(held);
    refer_to(result_.minimum.coefficients);
    bool has_own_reference = k == 0;
    std::size_t boxes_left = 0;
    std::priority_queue<Box> boxes;
    Box root;
    if (falloff_.constant) root.q[0] = {*falloff_.constant, *falloff_.constant};
    if (falloff_.end && !falloff_.constant) root.q[0].high = falloff_.largest_constant();
    boxes.push(root);
    while (!boxes.empty()) {
      Box box = boxes.top();
      boxes.pop();
      if (box.bound > target()) return;  // and so are all others
      if (!contract(box)) continue;
      if (++result_.boxes * (rows_ + kBoxEffort) > kLargestEffort) {
        result_.is_proven = false;
        return;
      }
      const Coefficients place = middle(box);
      if (falloff_.objective(place) < target()) {
        FalloffMinimum better = descend(falloff_, place);
        better.iterations += result_.minimum.iterations;
        if (better.objective < target()) {
          result_.minimum = better;
          bound_denominators(held);
          refer_to(better.coefficients);
          has_own_reference = k == 0;
        }
      }
      box.bound = std::max(box.bound, held + lower_bound(box, place));
      if (box.bound <= target() && !has_own_reference && ++boxes_left > kPatience) {
        has_own_reference = true;
        refer_to_held_minimum();
        box.bound = std::max(box.bound, held + lower_bound(box, place));
      }
      if (box.bound <= target()) split(box, boxes);
    }
  }

  /// Shrinks the box to where each D is within its bounds. False where nothing is left.
  bool contract(Box& box) const {
    for (int pass = 0; pass < 2; ++pass) {
      for (std::size_t i = 0; i < rows_; ++i) {
        if (!contract(box, terms_[i].x, terms_[i].d)) return false;
      }
      if (falloff_.end) {
        const double top = double(falloff_.end->top);
        if (!contract(box, falloff_.end->x, {top * (1 - kRounding), top * (1 + kRounding)})) return false;
      }
    }
    return true;
  }

  static bool contract(Box& box, double x, const Interval& d) {
    const Coefficients power{1, x, x * x};
    for (std::size_t j = 0; j < 3; ++j) {
      double low = 0, high = 0;  // what the others add up to
      for (std::size_t k = 0; k < 3; ++k) {
        if (k == j || !(power[k] > 0)) continue;
        low += power[k] * box.q[k].low;
        high += power[k] * box.q[k].high;
      }
      Interval& q = box.q[j];
      if (!(power[j] > 0)) continue;
      q.high = std::min(q.high, (d.high - low) / power[j]);
      q.low = std::max(q.low, (d.low - high) / power[j]);
      if (!(q.low <= q.high)) {
        if (!(q.low <= q.high * (1 + 4 * kRounding))) return false;
        q.low = q.high;
      }
    }
    return true;
  }

  /// A place in the box that meets the end.
  Coefficients middle(const Box& box) const {
    double share = 0.5;
    if (falloff_.end) {
      const Coefficients low{box.q[0].low, box.q[1].low, box.q[2].low};
      const Coefficients high{box.q[0].high, box.q[1].high, box.q[2].high};
      const double least = denominator(low, falloff_.end->x), most = denominator(high, falloff_.end->x);
      share = most > least ? std::clamp((double(falloff_.end->top) - least) / (most - least), 0.0, 1.0) : 0;
    }
    Coefficients place;
    for (std::size_t j = 0; j < 3; ++j) place[j] = box.q[j].low + share * (box.q[j].high - box.q[j].low);
    return place;
  }

  double lower_bound(const Box& box, const Coefficients& place) const {
    const Coefficients low{box.q[0].low, box.q[1].low, box.q[2].low};
    const Coefficients high{box.q[0].high, box.q[1].high, box.q[2].high};
    double level = 0;                      // sum of what each term is at least
    Plane here, there;                     // term by term: tangents at the place or the reference, or other lines
    Plane all_here, all_there;             // tangents of all terms
    Matrix curvature = Matrix::Zero();     // nowhere in the box is the objective's less
    Matrix curvature_to = Matrix::Zero();  // and nowhere from the reference to the box
    bool is_convex = true, is_place_smooth = true;
    for (std::size_t i = 0; i < rows_; ++i) {
      const Term& term = terms_[i];
      all_there.add(term.tangent, term.x);
      if (is_held(i)) {
        there.add(term.tangent, term.x);
        continue;
      }
      const double least = std::max(denominator(low, term.x), term.d.low);
      const double most = std::max(least, std::min(denominator(high, term.x), term.d.high));
      const Interval d{least, most}, log_d{std::log(least), std::log(most)};
      const double smallest = open_cost(term, std::clamp(term.y, log_d.low, log_d.high));
      level += smallest;
      const double d_place = std::max(denominator(place, term.x), kLeastSmooth);
      if (term.y > 0 && d_place == kLeastSmooth) is_place_smooth = false;
      all_here.add(tangent(term, d_place, std::log(d_place)), term.x);
      add_square(curvature, least_curvature(term, d.with(d_place), log_d.with(std::log(d_place))), term.x);
      add_square(curvature_to, least_curvature(term, d.with(term.reference_d), log_d.with(term.log_reference_d)),
                 term.x);
      if (is_convex_to(term, log_d.high)) {
        const double d_here = std::clamp(d_place, least, most);
        here.add(tangent(term, d_here, std::log(d_here)), term.x);
        if (is_convex_to(term, term.log_reference_d)) {
          there.add(term.tangent, term.x);
          continue;
        }
        there.add({smallest, 0}, term.x);
      } else {
        Line line{smallest, 0};
        if (least > 0 && log_d.low >= term.y + falloff_.loss.convex_limit() && most > least) {
          const double at_least = cost(term, log_d.low);
          const double slope = (cost(term, log_d.high) - at_least) / (most - least);
          line = {at_least - slope * least, slope};
        }
        here.add(line, term.x);
        there.add(line, term.x);
      }
      is_convex = false;
    }
    double bound =
        std::max({level, here.value + smallest_of(here.slope, box), there.value + smallest_of(there.slope, box)});
    if (is_convex) return bound;
    if (is_place_smooth) {
      bound = std::max(bound, all_here.value + smallest_of(all_here.slope, box) + smallest_bend(curvature, place, box));
    }
    if (is_reference_smooth_) {
      bound = std::max(
          bound, all_there.value + smallest_of(all_there.slope, box) + smallest_bend(curvature_to, reference_, box));
    }
    return bound;
  }

  /// A bound from below of a term's second derivative in D.
  double least_curvature(const Term& term, const Interval& d, const Interval& log_d) const {
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

  /// The smallest value on the box of the quadratic form with this curvature about a place; not above 0.
  double smallest_bend(const Matrix& curvature, const Coefficients& place, const Box& box) const {
    Eigen::Vector3d reach;
    for (std::size_t j = 0; j < 3; ++j) {
      reach[Eigen::Index(j)] = std::max({0.0, box.q[j].high - place[j], place[j] - box.q[j].low});
    }
    Matrix scaled = reach.asDiagonal() * curvature * reach.asDiagonal();
    if (falloff_.end) {  // across the plane of the end nothing moves
      const double e = falloff_.end->x;
      const Eigen::Vector3d across = reach.cwiseProduct(Eigen::Vector3d(1, e, e * e));
      if (across.squaredNorm() > 0) {
        scaled += 100 * scaled.cwiseAbs().maxCoeff() / across.squaredNorm() * across * across.transpose();
      }
    }
    if (!scaled.allFinite()) return -kInfinity;
    const double smallest = Eigen::SelfAdjointEigenSolver<Matrix>(scaled, Eigen::EigenvaluesOnly).eigenvalues()[0] -
                            1e-15 * scaled.cwiseAbs().maxCoeff();
    return 1.5 * std::min(0.0, smallest);  // half, times the squared length of at most 3
  }

  /// The smallest value of a linear function on the box, where it meets the end.
  double smallest_of(const Coefficients& slope, const Box& box) const {
    if (!falloff_.end) {
      double value = 0;
      for (std::size_t j = 0; j < 3; ++j) value += slope[j] * (slope[j] > 0 ? box.q[j].low : box.q[j].high);
      return value;
    }
    // From the low corner up to the end, first along what costs least for its share there.
    const double e = falloff_.end->x;
    const Coefficients power{1, e, e * e};
    std::array<std::size_t, 3> order{0, 1, 2};
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return slope[a] * power[b] < slope[b] * power[a]; });
    double value = 0, rest = double(falloff_.end->top);
    for (std::size_t j = 0; j < 3; ++j) {
      value += slope[j] * box.q[j].low;
      rest -= power[j] * box.q[j].low;
    }
    for (const std::size_t j : order) {
      const double part = std::clamp(rest, 0.0, power[j] * (box.q[j].high - box.q[j].low));
      value += slope[j] * part / power[j];
      rest -= part;
    }
    return value;
  }

  /// Along the coefficient that changes some D most, for its size; below 1 the clamp takes all changes.
  void split(const Box& box, std::priority_queue<Box>& boxes) const {
    const Coefficients place = middle(box);
    std::size_t widest = 0;
    double most = -1;
    for (std::size_t j = 0; j < 3; ++j) {
      const double width = box.q[j].high - box.q[j].low;
      for (const Term& term : terms_) {
        const double change =
            width * Coefficients{1, term.x, term.x * term.x}[j] / std::max(1.0, denominator(place, term.x));
        if (change > most) {
          most = change;
          widest = j;
        }
      }
    }
    const Interval whole = box.q[widest];
    // Bounds may be decades apart.
    double at = (whole.low + whole.high) / 2;
    if (whole.low > 0 && whole.high > 8 * whole.low) at = std::sqrt(whole.low) * std::sqrt(whole.high);
    if (whole.low == 0) at = whole.high / 8;
    if (!(at > whole.low && at < whole.high)) return;  // a box of neighbouring numbers
    Box part = box;
    part.q[widest] = {whole.low, at};
    boxes.push(part);
    part.q[widest] = {at, whole.high};
    boxes.push(part);
  }

  const Falloff& falloff_;
  std::vector<Term> terms_;
  std::size_t rows_;
  std::size_t held_count_ = 0;
  Coefficients reference_{};
  bool is_reference_smooth_ = false;  ///< no tangent there is another place's
  FalloffSearch result_;
};

}  // namespace

FalloffSearch search(const Falloff& falloff, const FalloffMinimum& local) { return Search(falloff, local).run(); }

}  // namespace litfog
