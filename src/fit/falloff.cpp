// SPDX-License-Identifier: Apache-2.0
#include "fit/falloff.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cassert>

#include "fit/active_set.h"

namespace litfog {
namespace {

/// The derivatives of the denominator at x by the coefficients.
template <typename Real>
std::array<Real, 3> powers(Real x) {
  return {Real(1), x, x * x};
}

std::vector<std::size_t> free_coefficients(const Falloff& falloff) {
  return falloff.constant ? std::vector<std::size_t>{1, 2} : std::vector<std::size_t>{0, 1, 2};
}

/// The required sum of the free coefficients' terms at the end.
long double rest_at_end(const Falloff& falloff) { return falloff.end->top - falloff.constant.value_or(0); }

/// The curvature of the terms in the second-order model.
enum class Bend {
  own,     ///< their own
  upward,  ///< at least an eighth of the Gauss-Newton method's, so that there is a minimum
};

/// The objective to second order in the coefficients, and its slopes if all residuals were 1 with the same sign.
template <typename Real>
struct Slopes {
  Real objective = 0;
  std::array<Real, 3> slope{};
  std::array<Real, 3> scale{};
  Eigen::Matrix<Real, 3, 3> curvature = Eigen::Matrix<Real, 3, 3>::Zero();
};

template <typename Real>
Slopes<Real> slopes_at(const Falloff& falloff, const std::array<Real, 3>& q, Bend bend = Bend::own) {
  using std::log;
  Slopes<Real> result;
  for (const auto& sample : falloff.samples) {
    const auto power = powers(Real(sample.x));
    const Real d = q[0] + power[1] * q[1] + power[2] * q[2];
    const bool is_level = falloff.is_level(d, sample);
    const Real z = (is_level ? 0 : log(d)) - Real(sample.y), weight = Real(sample.weight);
    result.objective += weight * falloff.loss.value(z);
    if (is_level) continue;
    const Real first = weight * falloff.loss.slope(z) / d;
    Real curvature = falloff.loss.curvature(z) - falloff.loss.slope(z);
    if (bend == Bend::upward) {
      const double root_slope = falloff.loss.root_slope(double(z));
      curvature = std::max(curvature, Real(root_slope * root_slope / 4));
    }
    const Real second = weight * curvature / (d * d);
    for (std::size_t j = 0; j < 3; ++j) {
      result.slope[j] += first * power[j];
      result.scale[j] += 2 * weight / d * power[j];
      for (std::size_t k = 0; k < 3; ++k) {
        result.curvature(Eigen::Index(j), Eigen::Index(k)) += second * power[j] * power[k];
      }
    }
  }
  return result;
}

/// Whether C is at its bound.
template <typename Real>
bool is_at_limit(const Falloff& falloff, const std::array<Real, 3>& q, std::size_t j) {
  return j == 0 && falloff.end && q[0] >= Real(falloff.largest_constant());
}

/// Subtracts the end's part from the slopes: 0 for each coefficient that is free to move.
template <typename Real>
void project_onto_end(const Falloff& falloff, const std::array<Real, 3>& q, std::array<Real, 3>& slope) {
  if (!falloff.end) return;
  const auto power = powers(Real(falloff.end->x));
  // The multiplier: a mean over the coefficients, weighted by their terms' fractions at the end.
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
  if (falloff.end) model.plane = {powers(Real(falloff.end->x)), Real(falloff.end->top)};
  return model;
}

/// A step towards the minimum of the second-order model.
///
/// damping   fraction by which the coefficients' own curvatures are raised (Marquardt), which shortens the step
/// releases  whether coefficients may leave their bounds
template <typename Real>
ActiveSetStep<Real, 3> newton_step(const Falloff& falloff, const std::array<Real, 3>& q, const Slopes<Real>& at,
                                   Real damping, bool releases) {
  auto model = model_at(falloff, q, at);
  model.curvature.diagonal() *= 1 + damping;
  auto slope_along_end = at.slope;
  project_onto_end(falloff, q, slope_along_end);
  auto free = free_variables(model, slope_along_end);
  if (!releases) std::erase_if(free, [&](std::size_t j) { return q[j] == model.lower[j] || q[j] == model.upper[j]; });
  auto step = active_set_step(model, free);
  // A coefficient at its bound may be driven across it by the others.
  while (step.blocked && step.point == q) {
    std::erase(free, *step.blocked);
    step = active_set_step(model, free);
  }
  return step;
}

/// Whether coefficients meet the end, but for rounding.
[[maybe_unused]] bool meets_end(const Falloff& falloff, const Coefficients& q) {
  return !falloff.end || std::abs(denominator(q, falloff.end->x) / double(falloff.end->top) - 1) < 1e-9;
}

/// The start with C within its bound; L and Q take up the difference.
Coefficients within_bounds(const Falloff& falloff, Coefficients q) {
  if (!falloff.end || falloff.constant || q[0] <= falloff.largest_constant()) return q;
  const auto power = powers(falloff.end->x);
  const double rest = q[1] * power[1] + q[2] * power[2];
  q[0] = falloff.largest_constant();
  const double wanted = double(falloff.end->top - static_cast<long double>(q[0]));
  if (!(rest > 0)) return {q[0], 0, wanted / power[2]};
  return {q[0], q[1] * wanted / rest, q[2] * wanted / rest};
}

/// Newton steps in extended precision, as long as slopes come nearer to 0 and the objective does not rise.
FalloffMinimum refine(const Falloff& falloff, FalloffMinimum minimum) {
  using Real = long double;
  constexpr double kRounding = 1e-16;  // slopes up to this release no coefficient from its bound
  const auto& start = minimum.coefficients;
  std::array<Real, 3> q{start[0], start[1], start[2]};
  Slopes<Real> at = slopes_at(falloff, q);
  Real kkt = kkt_residual_of(falloff, q, at);
  bool releases = false;
  for (int i = 0; i < 50 && kkt > 0; ++i) {
    const auto [next, blocked] = newton_step(falloff, q, at, Real(0), releases);
    const Slopes<Real> at_next = slopes_at(falloff, next);
    const Real next_kkt = kkt_residual_of(falloff, next, at_next);
    ++minimum.iterations;
    if (at_next.objective <= at.objective * (1 + 1e-12) + falloff.negligible() &&
        (next_kkt < kkt || (blocked && at_next.objective <= at.objective))) {
      q = next;
      at = at_next;
      kkt = next_kkt;
      releases = false;
    } else {
      if (releases || kkt <= kRounding) break;
      releases = true;
    }
  }
  minimum.coefficients = {double(q[0]), double(q[1]), double(q[2])};
  minimum.objective = falloff.objective(minimum.coefficients);
  assert(meets_end(falloff, minimum.coefficients));
  return minimum;
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
  // Each coefficient in units of its own curvature, so that the rank does not depend on units.
  Eigen::Vector3d unit;
  for (Eigen::Index j = 0; j < 3; ++j) unit[j] = normal(j, j) > 0 ? 1 / std::sqrt(normal(j, j)) : 1;
  normal = unit.asDiagonal() * normal * unit.asDiagonal();
  right = unit.asDiagonal() * right;
  Eigen::Vector3d at_end = Eigen::Vector3d::Zero();  // of a unit of each coefficient
  if (falloff.end) {
    const auto power = powers(falloff.end->x);
    at_end = unit.cwiseProduct(Eigen::Vector3d(power[0], power[1], power[2]));
  }
  // Tries every set of nonzero coefficients; the best one with positive least squares is the constrained optimum.
  Coefficients best{falloff.constant.value_or(0), 0, 0};
  double best_value = 0;
  if (falloff.end) {
    best_value = std::numeric_limits<double>::infinity();
    const std::size_t first = free_coefficients(falloff).front();
    best[first] = double(rest_at_end(falloff)) / powers(falloff.end->x)[first];
  }
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
      const double largest = at_end(chosen).maxCoeff();
      system.col(count).head(count) = system.row(count).head(count).transpose() = at_end(chosen) / largest;
      values[count] = double(rest_at_end(falloff)) / largest;
    }
    const Eigen::VectorXd solution = system.fullPivLu().solve(values);
    Eigen::Vector3d q = Eigen::Vector3d::Zero();
    q(chosen) = solution.head(count);
    if (falloff.end && count == 1) q(chosen).setConstant(1);  // to be put onto the end below
    if (!((q(chosen).array() > 0).all() && q.allFinite())) continue;
    if (falloff.end) q *= double(rest_at_end(falloff)) / at_end.dot(q);  // whatever the rank
    const double value = q.dot(normal * q) - 2 * right.dot(q);
    if (value < best_value) {
      best_value = value;
      best = {falloff.constant.value_or(unit[0] * q[0]), unit[1] * q[1], unit[2] * q[2]};
    }
  }
  return best;
}

FalloffMinimum approach(const Falloff& falloff, const Coefficients& start, double tolerance) {
  constexpr double kMinDamping = 1e-2, kMaxDamping = 1e8;
  // Fuzzing found a table whose zeros are released and blocked in turn without end, each time with a tiny fall.
  constexpr std::size_t kMaxSteps = 1000;
  FalloffMinimum minimum{.coefficients = within_bounds(falloff, start)};
  auto& q = minimum.coefficients;
  Slopes<double> at = slopes_at(falloff, q, Bend::upward);
  double damping = 0;
  bool releases = false;  // until the others are at a minimum, to find the minimum with more zeros
  while (damping < kMaxDamping && std::isfinite(at.objective) && minimum.iterations < kMaxSteps) {
    const auto [next, blocked] = newton_step(falloff, q, at, damping, releases);
    const Slopes<double> at_next = slopes_at(falloff, next, Bend::upward);
    ++minimum.iterations;
    const double fall = at.objective - at_next.objective;
    const bool is_done = !blocked && std::abs(fall) <= tolerance * at.objective + falloff.negligible();
    if (is_done && releases) break;
    if (fall > 0) {
      q = next;
      at = at_next;
      damping = damping > kMinDamping ? damping / 10 : 0;
    } else if (!is_done) {
      damping = std::max(10 * damping, kMinDamping);
    }
    releases = is_done;
  }
  minimum.objective = falloff.objective(q);
  return minimum;
}

FalloffMinimum descend(const Falloff& falloff, const Coefficients& start) {
  constexpr double kTolerance = 1e-14;  // below this, Newton steps converge without damping
  return refine(falloff, approach(falloff, start, kTolerance));
}

std::optional<std::array<double, 9>> covariance_of(const Falloff& falloff, const Coefficients& q) {
  constexpr double kRounding = 1e-12;  // relative rounding of slopes
  Slopes<double> at = slopes_at(falloff, q);
  project_onto_end(falloff, q, at.slope);
  std::vector<Eigen::Index> free;
  for (const std::size_t j : free_coefficients(falloff)) {
    const bool is_held = q[j] == 0 ? at.slope[j] > kRounding * at.scale[j] : is_at_limit(falloff, q, j);
    if (!is_held) free.push_back(Eigen::Index(j));
  }
  // The directions in which they can move: with an end, each against the one whose term is largest there.
  Eigen::Matrix3Xd directions = Eigen::Matrix3d::Identity()(Eigen::all, free);
  if (falloff.end && !free.empty()) {
    const auto power = powers(falloff.end->x);
    const auto term = [&](Eigen::Index j) { return q[std::size_t(j)] * power[std::size_t(j)]; };
    const Eigen::Index largest = *std::ranges::max_element(free, {}, term);
    std::erase(free, largest);
    directions = Eigen::Matrix3d::Identity()(Eigen::all, free);
    for (std::size_t m = 0; m < free.size(); ++m) {
      directions(largest, Eigen::Index(m)) = -power[std::size_t(free[m])] / power[std::size_t(largest)];
    }
  }
  std::array<double, 9> rows{};
  const auto count = Eigen::Index(falloff.samples.size());
  if (free.empty()) return rows;
  if (count <= directions.cols()) return std::nullopt;
  Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(count, directions.cols());
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto& sample = falloff.samples[std::size_t(i)];
    const double d = denominator(q, sample.x);
    if (falloff.is_level(d, sample)) continue;
    const double slope = std::sqrt(sample.weight) * falloff.loss.root_slope(std::log(d) - double(sample.y)) / d;
    jacobian.row(i) = slope * Eigen::RowVector3d(1, sample.x, sample.x * sample.x) * directions;
  }
  // Columns of one length: the rank must not depend on units.
  const Eigen::VectorXd lengths = jacobian.colwise().norm();
  if (!(lengths.array() > 0).all()) return std::nullopt;
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> decomposition(jacobian * lengths.cwiseInverse().asDiagonal());
  if (decomposition.rank() < directions.cols()) return std::nullopt;
  const Eigen::MatrixXd inverse = decomposition.matrixR()
                                      .topRows(directions.cols())
                                      .triangularView<Eigen::Upper>()
                                      .solve(Eigen::MatrixXd::Identity(directions.cols(), directions.cols()));
  const Eigen::Matrix3Xd root =
      directions * lengths.cwiseInverse().asDiagonal() * decomposition.colsPermutation() * inverse;
  const double variance = falloff.objective(q) / double(count - directions.cols());
  Eigen::Map<Eigen::Matrix3d>(rows.data()) = variance * root * root.transpose();  // symmetric: rows are columns
  return rows;
}

double kkt_residual(const Falloff& falloff, const Coefficients& q) {
  const std::array<long double, 3> wide{q[0], q[1], q[2]};
  return double(kkt_residual_of(falloff, wide, slopes_at(falloff, wide)));
}

}  // namespace litfog
