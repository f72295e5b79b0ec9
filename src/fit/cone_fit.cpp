// SPDX-License-Identifier: Apache-2.0
#include "litfog/fit/cone_fit.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "fit/branch_and_bound.h"
#include "fit/least_squares.h"
#include "litfog/formulas.h"
#include "require.h"
#include "versine.h"

namespace litfog {
namespace {

using std::numbers::pi;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kTolerance = 1e-3;  // of the objective: what is promised
constexpr double kGap = 5e-4;        // of it: left open by the bounds
constexpr double kEdgeCost = 4e-4;   // of it: for a cut-off where the beam ends rather than far out
constexpr double kExact = 1e-20;     // of the fractions' own sum: ten digits of each
constexpr std::size_t kMaxBoxes = 1'000'000;
constexpr int kMaxRounds = 20;       // of a descent that moves the cut
constexpr double kInvisible = 5e-4;  // fraction at which a cut-off does not show: 1.6 of 255 in sRGB
constexpr double kBeamLevel = 0.5;
constexpr double kFieldLevel = 0.1;

/// A sample as the fits see it.
struct Point {
  double angle;
  double cosine;
  double versine;   ///< 1 - cosine, to all digits
  double fraction;  ///< of the largest intensity
  double weight;

  Point(double angle_given, double fraction_given, double weight_given)
      : angle(angle_given),
        cosine(std::cos(angle_given)),
        versine(litfog::versine(angle_given)),
        fraction(fraction_given),
        weight(weight_given) {}

  double loss(double cone) const { return weight * (cone - fraction) * (cone - fraction); }
  /// The least loss where the cone is between two values.
  double loss(double least, double most) const { return loss(std::clamp(fraction, least, most)); }
};

double peak_of(const std::vector<ConeSample>& samples) {
  double peak = 0;
  for (const ConeSample& sample : samples) peak = std::max(peak, sample.intensity);
  return peak;
}

std::vector<Point> points_of(const ConeTarget& target) {
  std::vector<Point> points;
  if (target.beam_angle || target.field_angle) points.emplace_back(0, 1, 1);
  if (target.beam_angle) points.emplace_back(*target.beam_angle / 2, kBeamLevel, 1);
  if (target.field_angle) points.emplace_back(*target.field_angle / 2, kFieldLevel, 1);
  const double peak = peak_of(target.samples);
  for (const auto& [angle, intensity, weight] : target.samples) points.emplace_back(angle, intensity / peak, weight);
  std::stable_sort(points.begin(), points.end(), [](const Point& a, const Point& b) { return a.angle < b.angle; });
  return points;
}

/// One or two parameters of a profile.
using Parameters = std::array<double, 2>;

/// A range of each parameter.
struct Box {
  Parameters least;
  Parameters most;
};

/// Where a descent ended.
struct Candidate {
  Parameters parameters{};
  std::size_t lit = 0;  ///< of the cosine cone: the points inside its half angle
  double objective = kInfinity;
  double kkt_residual = 0;
  std::optional<std::vector<double>> covariance = std::nullopt;
};

/// The best parameters of a profile, and what is known of all others.
struct Optimum {
  Candidate best;
  double lower_bound = 0;
  std::size_t boxes = 0;
  std::size_t iterations = 0;
};

/// A profile's search as a problem for branch_and_bound. A profile has
///     root()                      the box of all parameters
///     bound(box)                  what no parameters in the box go below; infinite where the box holds no cone
///     start(box)                  some parameters in it, unless it holds no cone
///     objective(parameters)
///     descend(start, iterations)  the local minimum below a start
template <typename Profile>
class ConeSearch {
 public:
  ConeSearch(const Profile& profile, double exact) : profile_(profile), exact_(exact) {}

  Optimum run() {
    const BranchAndBoundResult result = branch_and_bound<Evaluation::eager>(*this, kMaxBoxes);
    optimum_.lower_bound = std::min(optimum_.best.objective, result.lower_bound);
    optimum_.boxes = result.boxes;
    return optimum_;
  }

  Box root() const { return profile_.root(); }
  bool contract(Box&) const { return true; }
  double bound(const Box& box) const { return profile_.bound(box); }
  bool is_closed(double bound) const {
    return optimum_.best.objective <= exact_ || bound >= (1 - kGap) * optimum_.best.objective;
  }
  void try_inside(const Box& box) {
    const std::optional<Parameters> start = profile_.start(box);
    if (!start || !(profile_.objective(*start) < optimum_.best.objective)) return;
    Candidate candidate = profile_.descend(*start, optimum_.iterations);
    if (candidate.objective < optimum_.best.objective) optimum_.best = std::move(candidate);
  }
  std::optional<std::array<Box, 2>> split(const Box& box) const {
    const std::size_t widest = box.most[0] - box.least[0] >= box.most[1] - box.least[1] ? 0 : 1;
    std::array<Box, 2> halves{box, box};
    halves[0].most[widest] = halves[1].least[widest] = (box.least[widest] + box.most[widest]) / 2;
    return halves;
  }

 private:
  const Profile& profile_;
  double exact_;
  Optimum optimum_;
};

/// The errors of both fits are differences of fractions, not their ratios: what light falls on a surface is seen by its
/// amount, and beams end in darkness, which has no logarithm.
struct CosineResidual {
  const Point& point;
  double edge;  ///< cosine of the half angle

  template <typename T>
  T operator()(const T& exponent) const {
    return std::sqrt(point.weight) * (formulas::cosine_cone(T(point.cosine), T(edge), exponent) - point.fraction);
  }
};

/// The formula sees differences of cosines alone, so it is given negative versines, which keep their digits near the
/// axis.
struct SmoothstepResidual {
  const Point& point;

  template <typename T>
  T operator()(const T& inner, const T& outer) const {
    return std::sqrt(point.weight) *
           (formulas::smoothstep_cone(T(-point.versine), T(-inner), T(-outer)) - point.fraction);
  }
};

/// cos^S u for u < H. Which points are lit depends on H alone, and the best of these for an S is found by one pass over
/// the points: the search is over S. Its parameter is 1 / (1 + S m), m = -ln cos u of a typical point, in [0, 1].
class CosineProfile {
 public:
  CosineProfile(const std::vector<Point>& points, std::optional<double> half_angle) : points_(points) {
    if (half_angle) {
      cuts_ = {lit_within(*half_angle)};
    } else {
      const std::size_t most = lit_within(pi / 2);
      for (std::size_t lit = 0; lit <= most; ++lit) {
        const bool parts_equals = lit > 0 && lit < points_.size() && points_[lit].cosine == points_[lit - 1].cosine;
        const bool is_on_axis = lit < points_.size() && points_[lit].cosine == 1;  // no cone leaves the axis dark
        if (!parts_equals && !is_on_axis) cuts_.push_back(lit);
      }
    }
    dark_losses_.assign(points_.size() + 1, 0);
    for (std::size_t i = points_.size(); i-- > 0;) dark_losses_[i] = dark_losses_[i + 1] + points_[i].loss(0);
    const auto first = std::find_if(points_.begin(), points_.end(), [](const Point& p) { return p.cosine < 1; });
    const auto last = points_.begin() + static_cast<std::ptrdiff_t>(cuts_.back());
    if (first < last) fall_ = -std::log(first[(last - first) / 2].cosine);
  }

  Box root() const { return {{0, 0}, {1, 0}}; }
  std::optional<Parameters> start(const Box& box) const { return Parameters{(box.least[0] + box.most[0]) / 2, 0}; }
  double objective(const Parameters& parameters) const {
    const double exponent = exponent_of(parameters[0]);
    return best_cut(exponent, exponent).second;
  }
  double bound(const Box& box) const { return best_cut(exponent_of(box.least[0]), exponent_of(box.most[0])).second; }

  Candidate descend(const Parameters& start, std::size_t& iterations) const {
    Candidate candidate;
    candidate.parameters = {exponent_of(start[0]), 0};
    // A round's cut is the best for the exponent of the round before.
    for (int round = 0; round < kMaxRounds; ++round) {
      const auto [lit, objective] = best_cut(candidate.parameters[0], candidate.parameters[0]);
      const bool is_settled = lit == candidate.lit && round > 0;
      candidate.lit = lit;
      candidate.objective = objective;
      if (is_settled) break;
      if (!is_exponent_seen(lit)) {
        candidate.parameters[0] = 0;
        candidate.covariance.reset();
        break;
      }
      const double edge = lit < points_.size() ? std::max(points_[lit].cosine, 0.0) : 0;
      const auto model = [this, edge](const auto* exponent, auto* residuals) {
        for (const Point& point : points_) *residuals++ = CosineResidual{point, edge}(*exponent);
      };
      const LeastSquaresFit fit = fit_least_squares(
          {.residual_count = points_.size(), .evaluate = differentiate<1>(model), .lower = {0}, .upper = {kInfinity}},
          {candidate.parameters.data(), 1}, Descent::one);
      candidate.parameters[0] = fit.parameters[0];
      candidate.kkt_residual = fit.gradient;
      candidate.covariance = fit.covariance;
      iterations += fit.iterations;
    }
    return candidate;
  }

  std::size_t lit_within(double angle) const {
    const double cosine = std::cos(angle);
    return static_cast<std::size_t>(
        std::count_if(points_.begin(), points_.end(), [cosine](const Point& p) { return p.cosine > cosine; }));
  }

  double objective_of(double exponent, std::size_t lit) const {
    double sum = dark_losses_[lit];
    for (std::size_t i = 0; i < lit; ++i) sum += points_[i].loss(std::pow(points_[i].cosine, exponent));
    return sum;
  }

 private:
  bool is_exponent_seen(std::size_t lit) const { return lit > 0 && points_[lit - 1].cosine < 1; }

  double exponent_of(double parameter) const { return (1 - parameter) / (parameter * fall_); }  // infinity at 0

  /// How many points are best lit, and the objective then, or its bound over a range of exponents.
  std::pair<std::size_t, double> best_cut(double most_exponent, double least_exponent) const {
    std::pair<std::size_t, double> best{0, kInfinity};
    double lit_loss = 0;
    std::size_t lit = 0;
    for (const std::size_t cut : cuts_) {
      for (; lit < cut; ++lit) {
        const Point& point = points_[lit];
        lit_loss += point.loss(std::pow(point.cosine, most_exponent), std::pow(point.cosine, least_exponent));
      }
      if (lit_loss + dark_losses_[cut] < best.second) best = {cut, lit_loss + dark_losses_[cut]};
    }
    return best;
  }

  const std::vector<Point>& points_;
  std::vector<std::size_t> cuts_;    // numbers of points that a cone can light, increasing
  std::vector<double> dark_losses_;  // of the points from each on, and 0
  double fall_ = 1;
};

/// smoothstep(cos outer, cos inner, cos u). Parameters are the versines of inner and outer.
class SmoothstepProfile {
 public:
  SmoothstepProfile(const std::vector<Point>& points, std::optional<double> outer) : points_(points) {
    if (outer) outer_ = versine(*outer);
  }

  Box root() const {
    const double farthest = outer_ ? *outer_ : points_.back().versine;
    return {{0, outer_ ? *outer_ : 0}, {farthest, outer_ ? *outer_ : 2}};
  }
  /// The middle, or near the diagonal the corner that is a cone.
  std::optional<Parameters> start(const Box& box) const {
    if (!(box.least[0] < box.most[1])) return std::nullopt;
    const Parameters middle{(box.least[0] + box.most[0]) / 2, (box.least[1] + box.most[1]) / 2};
    return middle[0] < middle[1] ? middle : Parameters{box.least[0], box.most[1]};
  }
  double objective(const Parameters& parameters) const {
    double sum = 0;
    for (const Point& point : points_) sum += point.loss(cone_at(point, parameters));
    return sum;
  }
  double bound(const Box& box) const {
    if (!(box.least[0] < box.most[1])) return kInfinity;
    // Where the ranges overlap, a step is the limit of the cones.
    const Parameters least{box.least[0], std::max(box.least[0], box.least[1])};
    const Parameters most{std::min(box.most[0], box.most[1]), box.most[1]};
    double sum = 0;
    for (const Point& point : points_) sum += point.loss(cone_at(point, least), cone_at(point, most));
    return sum;
  }

  Candidate descend(const Parameters& start, std::size_t& iterations) const {
    const auto edge_given = [this](const auto* inner, auto* residuals) {
      const std::decay_t<decltype(*inner)> outer(*outer_);
      for (const Point& point : points_) *residuals++ = SmoothstepResidual{point}(*inner, outer);
    };
    const auto edge_free = [this](const auto* edge, auto* residuals) {
      for (const Point& point : points_) *residuals++ = SmoothstepResidual{point}(edge[0], edge[1]);
    };
    const std::size_t count = outer_ ? 1 : 2;
    const LeastSquaresFit fit =
        fit_least_squares({.residual_count = points_.size(),
                           .evaluate = outer_ ? differentiate<1>(edge_given) : differentiate<2>(edge_free),
                           .lower = std::vector<double>(count, 0),
                           .upper = std::vector<double>(count, 2)},
                          {start.data(), count}, Descent::one);
    Candidate candidate;
    candidate.parameters[1] = outer_ ? *outer_ : fit.parameters[1];
    constexpr double kNarrowest = 1e-12;  // a descent may end in a step, which is the limit of cones
    candidate.parameters[0] = std::min(fit.parameters[0], candidate.parameters[1] * (1 - kNarrowest));
    candidate.objective = objective(candidate.parameters);
    candidate.kkt_residual = fit.gradient;
    candidate.covariance = fit.covariance;
    iterations += fit.iterations;
    return candidate;
  }

  /// The softest of the edges that all points see alike, where fewer of them are in the edge than it has parameters.
  Parameters softest(const Parameters& parameters, double exact, bool& is_identified) const {
    double full = 0;
    double dark = outer_ ? *outer_ : 2;
    double inside = 0;
    double part = 0;        // of the edge beyond it, linear in the versine
    std::size_t count = 0;  // of different angles
    for (const Point& point : points_) {
      const double cone = cone_at(point, parameters);
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
    Parameters result{full, dark};
    if (count == 1) {  // outer - inside = part * (outer - inner)
      const double outer = (inside - part * full) / (1 - part);
      result = outer <= dark ? Parameters{full, outer} : Parameters{(inside - (1 - part) * dark) / part, dark};
    }
    return objective(result) <= std::max(objective(parameters) * (1 + 1e-12), exact) ? result : parameters;
  }

 private:
  static double cone_at(const Point& point, const Parameters& parameters) {
    // Not even the limit of cones that end here lights it, and all light the axis.
    if (point.versine >= parameters[1] && point.versine > 0) return 0;
    return formulas::smoothstep_cone(-point.versine, -parameters[0], -parameters[1]);
  }

  const std::vector<Point>& points_;
  std::optional<double> outer_;  // versine, where given
};

/// Angle where the points first fall to a fraction of their peak, if they do.
std::optional<double> half_angle_of(const std::vector<Point>& points, double fraction) {
  std::vector<AxialSample> profile;
  for (const Point& point : points) profile.push_back({point.angle, point.fraction, 0});
  const double angle = half_angle(profile, fraction);
  return angle < profile.back().angle ? std::optional(angle) : std::nullopt;
}

/// Flux of samples, linear between them, from the first to the last.
double flux_of(const std::vector<ConeSample>& samples) {
  double sum = 0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const double half = (samples[i].angle - samples[i - 1].angle) / 2;
    const double middle = samples[i - 1].angle + half;
    const double mean = samples[i - 1].intensity / 2 + samples[i].intensity / 2;
    const double slope = (samples[i].intensity - samples[i - 1].intensity) / (2 * half);
    sum +=
        mean * std::sin(middle) * std::sin(half) + slope * std::cos(middle) * (std::sin(half) - half * std::cos(half));
  }
  return 4 * pi * sum;
}

/// The figures of a cone against its target, whatever found it.
ConeProfileFit assess(const Cone& cone, const std::vector<Point>& points, const ConeTarget& target) {
  ConeProfileFit fit{.cone = cone};
  double weights = 0;
  for (const Point& point : points) {
    const double error = cone_at(cone, point.cosine) - point.fraction;
    fit.objective += point.weight * error * error;
    weights += point.weight;
    if (std::abs(error) > std::abs(fit.largest_error)) {
      fit.largest_error = error;
      fit.largest_error_angle = point.angle;
    }
  }
  fit.rms = std::sqrt(fit.objective / weights);
  if (target.samples.size() > 1) {
    const double flux = flux_of(target.samples) / peak_of(target.samples);
    const auto [first, last] = std::pair(target.samples.front().angle, target.samples.back().angle);
    if (flux > 0) fit.flux_error = (flux_within(cone, last) - flux_within(cone, first)) / flux - 1;
  }
  const auto angle_error = [&](const std::optional<double>& stated, double level) -> std::optional<double> {
    const auto angle = stated ? *stated / 2 : half_angle_of(points, level);
    if (!angle) return std::nullopt;
    return angle_at_level(cone, level) / *angle - 1;
  };
  fit.beam_angle_error = angle_error(target.beam_angle, kBeamLevel);
  fit.field_angle_error = angle_error(target.field_angle, kFieldLevel);
  return fit;
}

void fill_in_proof(const Optimum& optimum, double exact, ConeProfileFit& fit) {
  const bool is_proven = optimum.best.objective <= exact || optimum.lower_bound >= (1 - kTolerance) * fit.objective;
  fit.status = is_proven ? ConeFitStatus::optimal : ConeFitStatus::unproven;
  fit.lower_bound = std::min(optimum.lower_bound, fit.objective);
  fit.kkt_residual = optimum.best.kkt_residual;
  fit.iterations = optimum.iterations;
  fit.boxes = optimum.boxes;
}

std::size_t count_off_axis(const std::vector<Point>& points) {
  return static_cast<std::size_t>(
      std::count_if(points.begin(), points.end(), [](const Point& point) { return point.versine > 0; }));
}

ConeProfileFit fit_cosine(const std::vector<Point>& points, const ConeTarget& target, double exact) {
  const CosineProfile profile(points, target.half_angle);
  const Optimum optimum = ConeSearch(profile, exact).run();
  const double exponent = optimum.best.parameters[0];
  const auto range_of = [&points](std::size_t lit) {
    return std::array{lit > 0 ? points[lit - 1].angle : 0,
                      lit < points.size() ? std::min(points[lit].angle, pi / 2) : pi / 2};
  };
  std::array<double, 2> range = range_of(optimum.best.lit);
  double half_angle = angle_at_level(Cone::cosine(pi / 2, exponent), kInvisible);
  const std::size_t lit = profile.lit_within(half_angle);
  if (target.half_angle) {
    half_angle = *target.half_angle;
    range = {half_angle, half_angle};
  } else if (profile.objective_of(exponent, lit) <= std::max(exact, (1 + kEdgeCost) * optimum.best.objective)) {
    range = range_of(lit);
  } else {
    half_angle = (range[0] + range[1]) / 2;
  }
  ConeProfileFit fit = assess(Cone::cosine(half_angle, exponent), points, target);
  fill_in_proof(optimum, exact, fit);
  fit.cutoff_range = range;
  if (optimum.best.covariance && count_off_axis(points) > 1) {
    fit.covariance = {{{optimum.best.covariance->front(), 0}, {0, 0}}};
  }
  return fit;
}

ConeProfileFit fit_smoothstep(const std::vector<Point>& points, const ConeTarget& target, double exact) {
  const SmoothstepProfile profile(points, target.half_angle);
  const Optimum optimum = ConeSearch(profile, exact).run();
  bool is_identified = false;
  const auto [inner, outer] = profile.softest(optimum.best.parameters, exact, is_identified);
  const auto angle_of = [&points](double versine) {  // a sample's own angle, to the digit
    const auto same = std::ranges::find(points, versine, &Point::versine);
    return same != points.end() ? same->angle : angle_of_versine(versine);
  };
  const Cone cone = Cone::smoothstep(angle_of(inner), target.half_angle ? *target.half_angle : angle_of(outer));
  ConeProfileFit fit = assess(cone, points, target);
  fill_in_proof(optimum, exact, fit);
  fit.cutoff_range = {cone.outer, cone.outer};
  const std::size_t count = target.half_angle ? 1 : 2;
  if (is_identified && optimum.best.covariance && count_off_axis(points) > count) {
    fit.covariance.emplace();
    for (std::size_t row = 0; row < count; ++row) {
      for (std::size_t column = 0; column < count; ++column) {
        const double value = (*optimum.best.covariance)[row * count + column];
        if (value == 0) continue;  // at a bound
        const auto slope = [&](std::size_t i) { return std::sin(i == 0 ? cone.inner : cone.outer); };
        (*fit.covariance)[row][column] = value / (slope(row) * slope(column));
      }
    }
  }
  return fit;
}

}  // namespace

std::optional<TargetError> check(const ConeTarget& target) {
  const auto error = [](const char* field, double value, const char* rule, std::optional<std::size_t> sample = {}) {
    return TargetError{{field, value, rule}, sample};
  };
  if (target.half_angle) {
    const bool is_wide = target.choice == ConeChoice::smoothstep;
    if (!(*target.half_angle > 0 && *target.half_angle <= (is_wide ? pi : pi / 2))) {
      return error("half_angle", *target.half_angle, is_wide ? "must be in (0, pi]" : "must be in (0, pi/2]");
    }
  }
  if (target.beam_angle && !(*target.beam_angle > 0 && *target.beam_angle <= 2 * pi)) {
    return error("beam_angle", *target.beam_angle, "must be in (0, 2 pi]");
  }
  if (target.field_angle && !(*target.field_angle > 0 && *target.field_angle <= 2 * pi)) {
    return error("field_angle", *target.field_angle, "must be in (0, 2 pi]");
  }
  if (target.beam_angle && target.field_angle && !(*target.field_angle > *target.beam_angle)) {
    return error("field_angle", *target.field_angle, "must be larger than the beam angle");
  }
  double peak = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < target.samples.size(); ++i) {
    const auto& [angle, intensity, weight] = target.samples[i];
    if (!(angle >= 0 && angle <= pi)) return error("angle", angle, "must be in [0, pi]", i);
    if (i > 0 && !(angle > target.samples[i - 1].angle)) {
      return error("angle", angle, "must be larger than the one before", i);
    }
    if (!is_finite_and_not_negative(intensity)) return error("intensity", intensity, "must be finite and >= 0", i);
    if (!(weight == 0 || (weight >= 1e-100 && weight <= 1e100))) {
      return error("weight", weight, "must be 0 or in [1e-100, 1e100]", i);
    }
    if (weight == 0) continue;
    ++count;
    peak = std::max(peak, intensity);
  }
  if (!target.beam_angle && !target.field_angle && count < 2) {
    return error("samples", double(count), "must be at least two with weight where no beam or field angle is given");
  }
  if (count > 0 && peak == 0) return error("samples.intensity", peak, "must be > 0 for one of the samples with weight");
  return std::nullopt;
}

std::vector<ConeSample> cone_samples(const std::vector<AxialSample>& profile) {
  std::vector<ConeSample> samples;
  for (const AxialSample& sample : profile) samples.push_back({sample.angle, sample.mean, 1});
  return samples;
}

ConeFit fit_cone(const ConeTarget& given) {
  if (const auto error = check(given)) throw std::invalid_argument(to_string(*error));
  ConeTarget target = given;
  std::erase_if(target.samples, [](const ConeSample& sample) { return sample.weight == 0; });
  const auto begin = std::chrono::steady_clock::now();
  const std::vector<Point> points = points_of(target);
  double exact = 0;
  for (const Point& point : points) exact += kExact * point.loss(0);

  ConeFit fit;
  if (target.choice != ConeChoice::smoothstep) fit.cosine = fit_cosine(points, target, exact);
  if (target.choice != ConeChoice::cosine) fit.smoothstep = fit_smoothstep(points, target, exact);
  const bool is_smoothstep_better =
      !fit.cosine ||
      (fit.smoothstep && fit.smoothstep->objective < fit.cosine->objective && fit.cosine->objective > exact);
  fit.profile = is_smoothstep_better ? ConeProfile::smoothstep : ConeProfile::cosine;
  fit.milliseconds = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
  return fit;
}

}  // namespace litfog
