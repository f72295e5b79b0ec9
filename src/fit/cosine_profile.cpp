// SPDX-License-Identifier: Apache-2.0
#include "fit/cosine_profile.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "fit/least_squares.h"
#include "litfog/formulas.h"

namespace litfog {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kMaxRounds = 20;  // largest number of moves of the cut in a descent

/// The error is a difference of fractions, not their ratio: the eye sees how much light falls on a surface, and
/// beams end in darkness, which has no logarithm.
struct CosineResidual {
  const ConePoint& point;
  double edge;  ///< cosine of the half angle

  template <typename T>
  T operator()(const T& exponent) const {
    return std::sqrt(point.weight) * (formulas::cosine_cone(T(point.cosine), T(edge), exponent) - point.fraction);
  }
};

/// The exponent at which the cone equals the point's fraction; NaN if rounding would blur it.
double own_exponent(const ConePoint& point) {
  constexpr double kPlain = 1e-6;  // smallest magnitude of a logarithm
  const bool is_plain = point.cosine > 0 && std::log(point.cosine) < 0 && std::abs(std::log(point.fraction)) > kPlain;
  return is_plain ? std::log(point.fraction) / std::log(point.cosine) : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

CosineProfile::CosineProfile(const std::vector<ConePoint>& points, std::optional<double> half_angle) : points_(points) {
  if (half_angle) {
    cuts_ = {lit_within(*half_angle)};
  } else {
    const std::size_t most = lit_within(std::numbers::pi / 2);
    for (std::size_t lit = 0; lit <= most; ++lit) {
      const bool parts_equals = lit > 0 && lit < points_.size() && points_[lit].cosine == points_[lit - 1].cosine;
      const bool is_on_axis = lit < points_.size() && points_[lit].cosine == 1;  // no cone leaves the axis dark
      if (!parts_equals && !is_on_axis) cuts_.push_back(lit);
    }
  }
  for (const ConePoint& point : points_) {
    own_exponents_.push_back(own_exponent(point));
    falls_.push_back(-std::log(point.cosine));
  }
  dark_losses_.assign(points_.size() + 1, 0);
  for (std::size_t i = points_.size(); i-- > 0;) dark_losses_[i] = dark_losses_[i + 1] + points_[i].loss(0);
  const auto first = std::find_if(points_.begin(), points_.end(), [](const ConePoint& p) { return p.cosine < 1; });
  const auto last = points_.begin() + std::ptrdiff_t(cuts_.back());
  if (first < last) fall_ = -std::log(first[(last - first) / 2].cosine);
}

std::optional<ConeParameters> CosineProfile::start(const ConeBox& box) const {
  return ConeParameters{(box.least[0] + box.most[0]) / 2, 0};
}

double CosineProfile::objective(const ConeParameters& parameters) const {
  constexpr std::size_t kMaxKept = 1 << 20;  // 8 MB
  const double exponent = exponent_of(parameters[0]);
  std::vector<double> powers;
  powers.reserve(cuts_.back());
  const double loss = best_cut([&](std::size_t i) {
                        powers.push_back(std::pow(points_[i].cosine, exponent));
                        return points_[i].loss(powers.back());
                      }).loss;
  if (powers_.size() * points_.size() < kMaxKept) powers_[exponent] = std::move(powers);
  return loss;
}

std::span<const double> CosineProfile::kept_powers(double exponent) const {
  const auto kept = powers_.find(exponent);
  return kept != powers_.end() ? kept->second : std::span<const double>();
}

/// With F the objective for some cut, m the box's middle, q = cos^S of a point and f its fraction,
///     F(S) >= F(m) - (distance from m to the box's end) * (steepest descent of F from m to there),
///     -dF/dS = sum of 2 weight (-ln cos) h(q),  h(q) = q (q - f),
/// where h is least at f / 2 and largest at an end of its range. Near a minimum this bound misses F by the square of
/// the width; a bound by each point alone misses it by the width. Uses the powers that objective() has kept.
double CosineProfile::bound(const ConeBox& box, double) const {
  const double most_exponent = exponent_of(box.least[0]), least_exponent = exponent_of(box.most[0]);
  const double middle = exponent_of((*start(box))[0]);
  const auto powers_at = [this](double exponent) {
    return [this, exponent, powers = kept_powers(exponent)](std::size_t i) {
      return i < powers.size() ? powers[i] : std::pow(points_[i].cosine, exponent);
    };
  };
  const auto least_at = powers_at(most_exponent), most_at = powers_at(least_exponent);
  const auto least_loss = [&](std::size_t i) {
    // Mostly the end nearer to the fraction is known without the powers.
    constexpr double kMargin = 1e-6;  // well above rounding
    const double below = own_exponents_[i] * (1 - kMargin), above = own_exponents_[i] * (1 + kMargin);
    if (least_exponent > above) return points_[i].loss(most_at(i));
    if (most_exponent < below) return points_[i].loss(least_at(i));
    if (least_exponent < below && most_exponent > above) return 0.0;
    return points_[i].loss(least_at(i), most_at(i));
  };
  const std::span<const double> middles =
      std::isfinite(most_exponent) ? kept_powers(middle) : std::span<const double>();
  double middle_loss = 0;
  double towards_least = 0, towards_most = 0;  // upper bounds of the objective's descents
  std::size_t known = 0;                       // number of points with known middles
  const auto lit_loss = [&](std::size_t i) {
    if (i < middles.size()) {
      const auto& [angle, cosine, versine, fraction, weight] = points_[i];
      const auto h = [f = fraction](double q) { return q * (q - f); };
      const double q = middles[i], factor = 2 * weight * falls_[i];
      middle_loss += points_[i].loss(q);
      towards_least -= factor * h(std::clamp(fraction / 2, q, std::max(q, most_at(i))));
      towards_most += factor * std::max(h(q), h(least_at(i)));
      known = i + 1;
    }
    return least_loss(i);
  };
  const auto loss = [&](double least_lit_loss, std::size_t lit) {
    if (lit > known) return least_lit_loss + dark_losses_[lit];
    const double descent =
        std::max({0.0, (middle - least_exponent) * towards_least, (most_exponent - middle) * towards_most});
    return std::max(least_lit_loss, middle_loss - descent) + dark_losses_[lit];
  };
  return best_cut(lit_loss, loss).loss;
}

ConeCandidate CosineProfile::descend(const ConeParameters& start, std::size_t& iterations) const {
  ConeCandidate candidate;
  candidate.parameters = {exponent_of(start[0]), 0};
  // A round's cut is the best for the previous round's exponent.
  for (int round = 0; round < kMaxRounds; ++round) {
    const auto [lit, objective] = best_cut_at(candidate.parameters[0]);
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
      for (const ConePoint& point : points_) *residuals++ = CosineResidual{point, edge}(*exponent);
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

std::size_t CosineProfile::lit_within(double angle) const {
  const double cosine = std::cos(angle);
  return std::size_t(
      std::count_if(points_.begin(), points_.end(), [cosine](const ConePoint& p) { return p.cosine > cosine; }));
}

std::optional<std::size_t> CosineProfile::first_cut(double exponent, std::size_t least_lit, double limit) const {
  const std::size_t last = std::max(least_lit, best_cut_at(exponent).lit);
  double lit_loss = 0;
  std::size_t lit = 0;
  for (const std::size_t cut : cuts_) {
    if (cut > last) break;
    for (; lit < cut; ++lit) lit_loss += points_[lit].loss(std::pow(points_[lit].cosine, exponent));
    if (cut >= least_lit && lit_loss + dark_losses_[cut] <= limit) return cut;
  }
  return std::nullopt;
}

template <typename Loss, typename TotalLoss>
CosineProfile::Cut CosineProfile::best_cut(const Loss& lit_loss_of, const TotalLoss& loss_of) const {
  Cut best{0, kInfinity};
  double lit_loss = 0;
  std::size_t lit = 0;
  for (const std::size_t cut : cuts_) {
    for (; lit < cut; ++lit) lit_loss += lit_loss_of(lit);
    if (lit_loss > best.loss) break;  // further cuts lose more
    if (const double loss = loss_of(lit_loss, cut); loss < best.loss) best = {cut, loss};
    if (dark_losses_[cut] == 0) break;  // all beyond is dark
  }
  return best;
}

template <typename Loss>
CosineProfile::Cut CosineProfile::best_cut(const Loss& lit_loss_of) const {
  return best_cut(lit_loss_of, [this](double lit_loss, std::size_t lit) { return lit_loss + dark_losses_[lit]; });
}

CosineProfile::Cut CosineProfile::best_cut_at(double exponent) const {
  return best_cut([&](std::size_t i) { return points_[i].loss(std::pow(points_[i].cosine, exponent)); });
}

}  // namespace litfog
