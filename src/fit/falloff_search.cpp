// SPDX-License-Identifier: Apache-2.0
#include "fit/falloff_search.h"

#include <algorithm>
#include <queue>

// The samples that the clamp holds at 1 are the first ones, for D rises with the range: so many, then no more. For each
// such number k the objective is smooth: a constant for the k samples, and beyond them terms that are convex in D up to
// e^limit of the sample and concave from there. Whatever is better than the best known has each term alone below the
// best objective, which bounds each D, and the boxes shrink to what these bounds leave. On a box each term lies above a
// line in D (tangent where convex, chord where concave, level where both), and so the objective above a linear function
// of the coefficients. The tangents at the best known minimum rule out at once all of a box in which every term is
// convex: there it is the only minimum.
//
// A sample with attenuation 1 is never held: its term is level up to D = 1, and convex from the start.

namespace litfog {
namespace {

constexpr double kGap = 1e-7;
constexpr double kRounding = 1e-13;  ///< by which bounds on D are widened
/// Terms evaluated before the search gives up: about a second.
constexpr std::size_t kLargestEffort = 20'000'000;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Interval {
  double low = 0;
  double high = kInfinity;
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

class Search {
 public:
  Search(const Falloff& falloff, const FalloffMinimum& local) : falloff_(falloff) {
    result_.minimum = local;
    for (const auto& sample : falloff.samples) terms_.push_back({sample.x, double(sample.y), sample.weight, {}, {}});
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
    Interval d;    ///< where the objective can be better than the best known
    Line tangent;  ///< at the best known
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

  /// Bounds of each D, and the tangents at the best known minimum.
  void know_the_best(double held) {
    const double spare = std::max(0.0, result_.minimum.objective + falloff_.negligible() - held);
    for (std::size_t i = 0; i < rows_; ++i) {
      Term& term = terms_[i];
      const double reach = falloff_.loss.residual(spare / term.weight);
      term.d = {term.y == 0 ? 0 : std::max(1.0, std::exp(term.y - reach)), std::exp(term.y + reach)};
      if (is_held(i)) term.d = {0, 1};
      term.d.low *= 1 - kRounding;
      term.d.high *= 1 + kRounding;
      const double d = denominator(result_.minimum.coefficients, term.x);
      const double log_d = std::log(d);
      has_tangents_ = (i == 0 || has_tangents_) && (is_held(i) || (d > 0 && is_convex_to(term, log_d)));
      term.tangent = tangent(term, d, log_d);
      if (is_held(i)) {
        // Beside the constant, any rising line that ends in 0 at D = 1: that which the best known minimum leans on.
        const double slope = d > 1 ? std::max(0.0, term.tangent.slope) : 0;
        term.tangent = {-slope, slope};
      }
    }
  }

  void search_with_held(std::size_t k, double held) {
    held_count_ = k;
    know_the_best(held);
    std::priority_queue<Box> boxes;
    Box root;
    if (falloff_.constant) root.q[0] = {*falloff_.constant, *falloff_.constant};
    if (falloff_.end && !falloff_.constant) root.q[0].high = double(falloff_.end->top) * kLargestConstantShare;
    boxes.push(root);
    while (!boxes.empty()) {
      Box box = boxes.top();
      boxes.pop();
      if (box.bound > target()) return;  // and so are all others
      if (!contract(box)) continue;
      if (++result_.boxes * rows_ > kLargestEffort) {
        result_.is_proven = false;
        return;
      }
      const Coefficients place = middle(box);
      const double objective = falloff_.objective(place);
      if (objective < target()) {
        FalloffMinimum better = descend(falloff_, place);
        better.iterations += result_.minimum.iterations;
        if (better.objective < target()) {
          result_.minimum = better;
          know_the_best(held);
        }
      }
      box.bound = std::max(box.bound, held + lower_bound(box, place));
      if (box.bound > target()) continue;
      split(box, boxes);
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
    double level = 0;  // sum of what each term is at least
    Coefficients here{}, best{};
    double here_value = 0, best_value = 0;
    const auto add = [](const Line& line, double x, Coefficients& slope, double& value) {
      value += line.value;
      slope[0] += line.slope;
      slope[1] += line.slope * x;
      slope[2] += line.slope * x * x;
    };
    for (std::size_t i = 0; i < rows_; ++i) {
      const Term& term = terms_[i];
      if (is_held(i)) {
        add(term.tangent, term.x, best, best_value);
        continue;
      }
      const double least = std::max(denominator(low, term.x), term.d.low);
      const double most = std::max(least, std::min(denominator(high, term.x), term.d.high));
      const double log_least = std::log(least), log_most = std::log(most);
      const double smallest = open_cost(term, std::clamp(term.y, log_least, log_most));
      level += smallest;
      if (is_convex_to(term, log_most)) {
        const double d = std::clamp(denominator(place, term.x), least, most);
        add(tangent(term, d, std::log(d)), term.x, here, here_value);
        add(has_tangents_ ? term.tangent : Line{smallest, 0}, term.x, best, best_value);
        continue;
      }
      Line line{smallest, 0};
      if (least > 0 && log_least >= term.y + falloff_.loss.convex_limit() && most > least) {
        const double at_least = cost(term, log_least);
        const double slope = (cost(term, log_most) - at_least) / (most - least);
        line = {at_least - slope * least, slope};
      }
      add(line, term.x, here, here_value);
      add(line, term.x, best, best_value);
    }
    return std::max({level, here_value + smallest_of(here, box), best_value + smallest_of(best, box)});
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
  bool has_tangents_ = false;
  FalloffSearch result_;
};

}  // namespace

FalloffSearch search(const Falloff& falloff, const FalloffMinimum& local) { return Search(falloff, local).run(); }

}  // namespace litfog
