// SPDX-License-Identifier: Apache-2.0
#include "fit/falloff.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cassert>
#include <limits>

#include "fit/active_set.h"

namespace litfog {
namespace {

/// What the coefficients do to the denominator at x.
template <typename Real>
std::array<Real, 3> powers(Real x) {
  return {Real(1), x, x * x};
}

std::vector<std::size_t> free_coefficients(const Falloff& falloff) {
  return falloff.constant ? std::vector<std::size_t>{1, 2} : std::vector<std::size_t>{0, 1, 2};
}

/// What the free coefficients' terms must add up to at the end.
long double rest_at_end(const Falloff& falloff) { return falloff.end->top - falloff.constant.value_or(0); }

/// The coefficients as parameters within plain bounds. Without an end they are themselves, in units of the largest
/// value that exceeds no sample; with one, C's fraction of the top and L's fraction of the rest. Those that start at a
/// bound are left out: bounds that hold cost Ceres many steps.
class Parameters {
 public:
  Parameters(const Falloff& falloff, const Coefficients& start) : falloff_(falloff), free_(free_coefficients(falloff)) {
    if (falloff.end) {
      const auto [e, top] = *falloff.end;
      if (!falloff.constant)
        all_.push_back(start[0] < falloff.largest_constant() ? start[0] / double(top) : kLargestConstantFraction);
      const double linear = start[1] * e, quadratic = start[2] * e * e;
      all_.push_back(linear + quadratic > 0 ? linear / (linear + quadratic) : 0);
    } else {
      for (const std::size_t j : free_) {
        double unit = std::numeric_limits<double>::infinity();
        for (const auto& [x, y, weight] : falloff.samples) {
          if (j == 0 || x > 0) unit = std::min(unit, std::exp(double(y)) / powers(x)[j]);
        }
        units_[j] = unit;
        all_.push_back(start[j] / unit);
      }
    }
    for (std::size_t k = 0; k < all_.size(); ++k) {
      if (all_[k] > 0 && all_[k] < upper_bound(k)) moving_.push_back(k);
    }
  }

  std::size_t count() const { return moving_.size(); }

  std::vector<double> start() const {
    std::vector<double> result;
    for (const std::size_t k : moving_) result.push_back(all_[k]);
    return result;
  }
  std::vector<double> lower() const { return std::vector<double>(count(), 0.0); }
  std::vector<double> upper() const {
    std::vector<double> result;
    for (const std::size_t k : moving_) result.push_back(upper_bound(k));
    return result;
  }

  Coefficients coefficients(std::span<const double> parameters) const {
    const auto all = filled(parameters);
    Coefficients q{falloff_.constant.value_or(0), 0, 0};
    if (!falloff_.end) {
      for (std::size_t k = 0; k < free_.size(); ++k) q[free_[k]] = units_[free_[k]] * all[k];
      return q;
    }
    const double e = falloff_.end->x;
    if (!falloff_.constant) q[0] = double(falloff_.end->top) * all[0];
    const double rest = rest_of(all);
    q[1] = rest * all.back() / e;
    q[2] = rest * (1 - all.back()) / e / e;
    return q;
  }

  /// Derivatives of the coefficients by the i-th parameter.
  Coefficients slope(std::span<const double> parameters, std::size_t i) const {
    const auto all = filled(parameters);
    const std::size_t k = moving_[i];
    Coefficients slope{};
    if (!falloff_.end) {
      slope[free_[k]] = units_[free_[k]];
      return slope;
    }
    const double e = falloff_.end->x, top = double(falloff_.end->top);
    if (k + 1 < all.size()) return {top, -top * all.back() / e, -top * (1 - all.back()) / e / e};
    return {0, rest_of(all) / e, -rest_of(all) / e / e};
  }

 private:
  double upper_bound(std::size_t k) const {
    if (!falloff_.end) return std::numeric_limits<double>::infinity();
    return k + 1 < all_.size() ? kLargestConstantFraction : 1;
  }

  std::vector<double> filled(std::span<const double> parameters) const {
    std::vector<double> all = all_;
    for (std::size_t i = 0; i < count(); ++i) all[moving_[i]] = parameters[i];
    return all;
  }

  /// What is left at the end for L and Q.
  double rest_of(const std::vector<double>& all) const {
    return double(rest_at_end(falloff_)) * (falloff_.constant ? 1 : 1 - all[0]);
  }

  const Falloff& falloff_;
  std::vector<std::size_t> free_;
  std::vector<double> all_;
  std::vector<std::size_t> moving_;
  Coefficients units_{1, 1, 1};
};

/// Which coefficients are 0.
std::array<bool, 3> zeros(const Coefficients& q) { return {q[0] == 0, q[1] == 0, q[2] == 0}; }

/// Slope of the objective in the coefficients, and what it would be if all residuals were 1 with the same sign.
template <typename Real>
struct Slopes {
  std::array<Real, 3> slope{};
  std::array<Real, 3> scale{};
  Eigen::Matrix<Real, 3, 3> curvature = Eigen::Matrix<Real, 3, 3>::Zero();
};

template <typename Real>
Slopes<Real> slopes_at(const Falloff& falloff, const std::array<Real, 3>& q) {
  using std::log;
  Slopes<Real> result;
  for (const auto& sample : falloff.samples) {
    const auto power = powers(Real(sample.x));
    const Real d = q[0] + power[1] * q[1] + power[2] * q[2];
    if (d < 1 && falloff.is_clamped_at(sample)) continue;  // at 1 only the slope above counts: below, the clamp holds
    const Real z = log(d) - Real(sample.y);
    const Real first = Real(sample.weight) * falloff.loss.slope(z) / d;
    const Real second = Real(sample.weight) * (falloff.loss.curvature(z) - falloff.loss.slope(z)) / (d * d);
    for (std::size_t j = 0; j < 3; ++j) {
      result.slope[j] += first * power[j];
      result.scale[j] += 2 * Real(sample.weight) / d * power[j];
      for (std::size_t k = 0; k < 3; ++k) {
        result.curvature(Eigen::Index(j), Eigen::Index(k)) += second * power[j] * power[k];
      }
    }
  }
  return result;
}

/// C at its bound.
template <typename Real>
bool is_at_limit(const Falloff& falloff, const std::array<Real, 3>& q, std::size_t j) {
  return j == 0 && falloff.end && q[0] >= Real(falloff.largest_constant());
}

/// The slopes minus what the end takes up: 0 for each coefficient that is free to move.
template <typename Real>
void project_onto_end(const Falloff& falloff, const std::array<Real, 3>& q, std::array<Real, 3>& slope) {
  if (!falloff.end) return;
  const auto power = powers(Real(falloff.end->x));
  // The multiplier in the mean of the terms at the end, weighted by its fraction of them.
  Real sum = 0, weight = 0;
  for (const std::size_t j : free_coefficients(falloff)) {
    if (is_at_limit(falloff, q, j)) continue;  // held at its own bound
    sum += q[j] * slope[j];
    weight += q[j] * power[j];
  }
  if (!(weight > 0)) return;
  for (const std::size_t j : free_coefficients(falloff)) slope[j] -= sum / weight * power[j];
}

template <typename Real>
Real kkt_residual_of(const Falloff& falloff, const std::array<Real, 3>& q, Slopes<Real> at) {
  project_onto_end(falloff, q, at.slope);
  if (falloff.end) {  // one scale for all: each slope contains the multiplier's rounding
    const auto power = powers(Real(falloff.end->x));
    Real most = 0;
    for (const std::size_t j : free_coefficients(falloff)) most = std::max(most, at.scale[j] / power[j]);
    for (const std::size_t j : free_coefficients(falloff)) at.scale[j] = most * power[j];
  }
  Real worst = 0;
  for (const std::size_t j : free_coefficients(falloff)) {
    if (at.scale[j] == 0) continue;
    const Real violation = q[j] == 0                    ? std::max(Real(0), -at.slope[j])
                           : is_at_limit(falloff, q, j) ? std::max(Real(0), at.slope[j])
                                                        : std::abs(at.slope[j]);
    worst = std::max(worst, violation / at.scale[j]);
  }
  return worst;
}

/// The objective to second order about some coefficients, and their bounds.
template <typename Real>
BoundedModel<Real, 3> model_at(const Falloff& falloff, const std::array<Real, 3>& q, const Slopes<Real>& at) {
  constexpr Real kInfinity = std::numeric_limits<Real>::infinity();
  BoundedModel<Real, 3> model{q, at.slope, at.curvature, {0, 0, 0}, {kInfinity, kInfinity, kInfinity}};
  if (falloff.constant) {
    model.lower[0] = model.upper[0] = q[0];
  } else if (falloff.end) {
    model.upper[0] = Real(falloff.largest_constant());
  }
  if (falloff.end) model.plane = {powers(Real(falloff.end->x)), falloff.end->top};
  return model;
}

/// Newton steps in extended precision, as long as they bring the slopes nearer to 0 and the objective does not rise.
/// Gauss-Newton neglects the curvature of large residuals and converges slowly there.
Coefficients refine(const Falloff& falloff, const Coefficients& start) {
  using Real = long double;
  const auto rounded = [](const std::array<Real, 3>& q) {
    return Coefficients{double(q[0]), double(q[1]), double(q[2])};
  };
  std::array<Real, 3> q{start[0], start[1], start[2]};
  Slopes<Real> at = slopes_at(falloff, q);
  Real kkt = kkt_residual_of(falloff, q, at);
  double objective = falloff.objective(start);
  for (int i = 0; i < 50 && kkt > 0; ++i) {
    auto slope_along_end = at.slope;
    project_onto_end(falloff, q, slope_along_end);
    const auto model = model_at(falloff, q, at);
    const auto [next, blocked] = active_set_step(model, free_variables(model, slope_along_end));
    const double next_objective = falloff.objective(rounded(next));
    if (!(next_objective <= objective * (1 + 1e-12) + falloff.negligible())) break;
    const Slopes<Real> at_next = slopes_at(falloff, next);
    const Real next_kkt = kkt_residual_of(falloff, next, at_next);
    if (!(next_kkt < kkt) && !(blocked && next_objective <= objective)) break;
    q = next;
    at = at_next;
    kkt = next_kkt;
    objective = next_objective;
  }
  return rounded(q);
}

}  // namespace

Loss::Loss(double scale) : scale_(scale), is_plain_(std::isinf(scale)), convex_limit_(1) {
  // z (1 + (z/s)^2) = 1 has one root in (0, 1]; bisected, because it is needed once a fit.
  double low = 0;
  for (int i = 0; i < 60 && std::isfinite(scale); ++i) {
    const double middle = (low + convex_limit_) / 2;
    (middle * stretch(middle) * stretch(middle) > 1 ? convex_limit_ : low) = middle;
  }
}

double Falloff::weight_sum() const {
  double sum = 0;
  for (const Sample& sample : samples) sum += sample.weight;
  return sum;
}

double Falloff::objective(const Coefficients& q) const {
  double sum = 0;
  for (const Sample& sample : samples) sum += sample.weight * loss.value(residual(q, sample));
  return sum;
}

Coefficients linear_start(const Falloff& falloff) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const auto& [x, y, weight] : falloff.samples) {
    const double a = std::exp(-double(y));
    const auto power = powers(x);
    const Eigen::Vector3d row = a * Eigen::Vector3d(power[0], power[1], power[2]);
    normal += weight * row * row.transpose();
    right += weight * (1 - a * falloff.constant.value_or(0)) * row;
  }
  // Every set of coefficients that are not 0; the best whose least squares are positive is the constrained optimum.
  Coefficients best{falloff.constant.value_or(0), 0, 0};
  double best_value = falloff.end ? std::numeric_limits<double>::infinity() : 0;
  for (unsigned set = 1; set < 8; ++set) {
    if (falloff.constant && (set & 1) != 0) continue;
    std::vector<Eigen::Index> chosen;
    for (Eigen::Index j = 0; j < 3; ++j) {
      if ((set >> j & 1) != 0) chosen.push_back(j);
    }
    const auto count = Eigen::Index(chosen.size());
    const Eigen::Index size = count + (falloff.end ? 1 : 0);
    Eigen::MatrixXd system = Eigen::MatrixXd::Zero(size, size);
    Eigen::VectorXd values(size);
    system.topLeftCorner(count, count) = normal(chosen, chosen);
    values.head(count) = right(chosen);
    if (falloff.end) {
      const auto power = powers(falloff.end->x);
      for (Eigen::Index j = 0; j < count; ++j) {
        system(j, count) = system(count, j) = power[std::size_t(chosen[std::size_t(j)])];
      }
      values[count] = double(rest_at_end(falloff));
    }
    const Eigen::VectorXd solution = system.fullPivLu().solve(values);
    Eigen::Vector3d q = Eigen::Vector3d::Zero();
    q(chosen) = solution.head(count);
    if (!((solution.head(count).array() > 0).all() && q.allFinite())) continue;
    const double value = q.dot(normal * q) - 2 * right.dot(q);
    if (value < best_value) {
      best_value = value;
      best = {falloff.constant.value_or(q[0]), q[1], q[2]};
    }
  }
  return best;
}

namespace {

/// What Ceres squares: ln attenuation, because the errors of a falloff table are fractions of values that span decades,
/// weighted, and bent so that its square is the loss. It is written over D, in which the coefficients are linear, so
/// that one derivative does for all of them.
struct FalloffResidual {
  const Falloff& falloff;
  const Falloff::Sample& sample;

  template <typename T>
  T operator()(const T& d) const {
    return std::sqrt(sample.weight) * falloff.loss.root(falloff.residual(d, sample));
  }
};

/// One descent among the coefficients that are not 0, and Newton steps among all.
FalloffMinimum descend_once(const Falloff& falloff, const Coefficients& start) {
  const Parameters parameters(falloff, start);
  FalloffMinimum minimum;
  minimum.coefficients = parameters.coefficients(parameters.start());
  const std::size_t count = parameters.count();
  if (count > 0) {
    LeastSquaresProblem problem;
    problem.residual_count = falloff.samples.size();
    problem.lower = parameters.lower();
    problem.upper = parameters.upper();
    problem.evaluate = [&](std::span<const double> values, std::span<double> residuals, std::span<double> jacobian) {
      const Coefficients q = parameters.coefficients(values);
      std::array<Coefficients, 3> slopes;
      for (std::size_t k = 0; k < count; ++k) slopes[k] = parameters.slope(values, k);
      for (std::size_t i = 0; i < falloff.samples.size(); ++i) {
        const auto& sample = falloff.samples[i];
        using Jet = ceres::Jet<double, 1>;
        const Jet residual = FalloffResidual{falloff, sample}(Jet(denominator(q, sample.x), 0));
        residuals[i] = residual.a;
        if (jacobian.empty()) continue;
        for (std::size_t k = 0; k < count; ++k)
          jacobian[i * count + k] = residual.v[0] * denominator(slopes[k], sample.x);
      }
      return true;
    };
    const LeastSquaresFit fit = fit_least_squares(problem, parameters.start(), Descent::one);
    minimum.coefficients = parameters.coefficients(fit.parameters);
    minimum.iterations = fit.iterations;
    if (fit.covariance) {
      Eigen::Matrix<double, 3, 3, Eigen::RowMajor> covariance = Eigen::Matrix3d::Zero();
      for (std::size_t k = 0; k < count; ++k) {
        const Coefficients left = parameters.slope(fit.parameters, k);
        for (std::size_t l = 0; l < count; ++l) {
          const Coefficients right = parameters.slope(fit.parameters, l);
          covariance += (*fit.covariance)[k * count + l] * Eigen::Map<const Eigen::Vector3d>(left.data()) *
                        Eigen::Map<const Eigen::RowVector3d>(right.data());
        }
      }
      std::copy_n(covariance.data(), 9, minimum.covariance.emplace().data());
    }
  } else {
    minimum.covariance.emplace().fill(0);
  }
  // A fraction next to 1 has no digits left for the other term, which may matter far beyond the end.
  const bool may_start = !falloff.end || falloff.constant || start[0] <= falloff.largest_constant();
  if (may_start && falloff.objective(start) < falloff.objective(minimum.coefficients)) minimum.coefficients = start;
  minimum.coefficients = refine(falloff, minimum.coefficients);
  minimum.objective = falloff.objective(minimum.coefficients);
  return minimum;
}

}  // namespace

FalloffMinimum descend(const Falloff& falloff, const Coefficients& start) {
  FalloffMinimum minimum = descend_once(falloff, start);
  // Once more if the coefficients that ended at 0 are not those left out: for the covariance, and to converge fully.
  std::array<bool, 3> left_out = zeros(start);
  for (int i = 0; i < 4 && zeros(minimum.coefficients) != left_out; ++i) {
    left_out = zeros(minimum.coefficients);
    const std::size_t iterations = minimum.iterations;
    minimum = descend_once(falloff, minimum.coefficients);
    minimum.iterations += iterations;
  }
  return minimum;
}

double kkt_residual(const Falloff& falloff, const Coefficients& q) {
  const std::array<long double, 3> wide{q[0], q[1], q[2]};
  return double(kkt_residual_of(falloff, wide, slopes_at(falloff, wide)));
}

}  // namespace litfog
