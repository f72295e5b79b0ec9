// SPDX-License-Identifier: Apache-2.0
#include "fit/least_squares.h"

#include <ceres/ceres.h>

#include <Eigen/Dense>
#include <cassert>
#include <cmath>

namespace litfog {
namespace {

using Eigen::Index;
using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Vector = Eigen::VectorXd;

bool is_finite(double x) { return std::isfinite(x); }

/// The problem as a Ceres cost function.
class CostFunction final : public ceres::CostFunction {
 public:
  CostFunction(const LeastSquaresProblem& problem, std::size_t parameter_count)
      : problem_(problem), parameter_count_(parameter_count) {
    set_num_residuals(int(problem.residual_count));
    mutable_parameter_block_sizes()->push_back(int(parameter_count));
  }

  bool Evaluate(const double* const* parameters, double* residuals, double** jacobians) const override {
    double* jacobian = jacobians != nullptr ? jacobians[0] : nullptr;
    const std::size_t size = jacobian != nullptr ? problem_.residual_count * parameter_count_ : 0;
    // False tells Ceres to step elsewhere; a value that is not finite makes it report an error and print a page.
    return problem_.evaluate({parameters[0], parameter_count_}, {residuals, problem_.residual_count},
                             {jacobian, size}) &&
           std::all_of(residuals, residuals + problem_.residual_count, is_finite) &&
           std::all_of(jacobian, jacobian + size, is_finite);
  }

 private:
  const LeastSquaresProblem& problem_;
  std::size_t parameter_count_;
};

/// The problem at some parameters.
struct Iterate {
  Vector parameters;
  Vector residuals;
  Matrix jacobian;
  std::vector<bool> is_held;  ///< at a bound, and the objective falls beyond it
  Vector step;                ///< Gauss-Newton step in the free parameters
  double projection = 0;      ///< norm of the residuals projected onto the free columns of the Jacobian
  double gradient = 0;
  double relative_step = 0;  ///< both by their effect on the residuals
  bool has_full_rank = false;
  Matrix covariance;  ///< without the factor of the variance

  double objective() const { return 0.5 * residuals.squaredNorm(); }
};

bool has_converged(const Iterate& iterate) { return iterate.gradient <= 1e-6 || iterate.relative_step <= 1e-10; }

/// Whether a parameter is at a bound.
bool is_at_lower(const LeastSquaresProblem& problem, const Vector& parameters, Index i) {
  const auto at = std::size_t(i);
  return at < problem.lower.size() && parameters[i] <= problem.lower[at];
}
bool is_at_upper(const LeastSquaresProblem& problem, const Vector& parameters, Index i) {
  const auto at = std::size_t(i);
  return at < problem.upper.size() && parameters[i] >= problem.upper[at];
}

/// Finds the free parameters, and the linear least squares in them. Columns are normalised first, because the rank must
/// not depend on the parameters' units.
void solve_linear(const LeastSquaresProblem& problem, Iterate& iterate) {
  const Vector slope = iterate.jacobian.transpose() * iterate.residuals;
  std::vector<Index> free;
  for (Index i = 0; i < iterate.parameters.size(); ++i) {
    const bool is_held = (is_at_lower(problem, iterate.parameters, i) && slope[i] >= 0) ||
                         (is_at_upper(problem, iterate.parameters, i) && slope[i] <= 0);
    iterate.is_held.push_back(is_held);
    if (!is_held) free.push_back(i);
  }
  const auto free_count = Index(free.size());
  iterate.step = Vector::Zero(iterate.parameters.size());
  iterate.covariance = Matrix::Zero(iterate.parameters.size(), iterate.parameters.size());
  iterate.has_full_rank = iterate.residuals.size() >= free_count;
  if (free_count == 0) return;

  Matrix columns(iterate.residuals.size(), free_count);
  Vector lengths(free_count);
  Vector scaled_parameters(free_count);
  for (Index i = 0; i < free_count; ++i) {
    const Index at = free[std::size_t(i)];
    const auto column = iterate.jacobian.col(at);
    lengths[i] = column.norm();
    columns.col(i) = lengths[i] > 0 ? Vector(column / lengths[i]) : Vector::Zero(columns.rows());
    scaled_parameters[i] = lengths[i] * iterate.parameters[at];
  }
  const double residual_length = iterate.residuals.norm();
  if (residual_length > 0) {
    iterate.gradient = (columns.transpose() * iterate.residuals).cwiseAbs().maxCoeff() / residual_length;
  }
  const Eigen::ColPivHouseholderQR<Matrix> decomposition(columns);
  const Index rank = decomposition.rank();
  iterate.has_full_rank = rank == free_count;
  iterate.projection = (decomposition.householderQ().adjoint() * iterate.residuals).head(rank).norm();
  const Vector step = -decomposition.solve(iterate.residuals);
  const double parameter_length = scaled_parameters.norm();
  iterate.relative_step = parameter_length > 0 ? step.norm() / parameter_length : step.norm();
  Matrix covariance = Matrix::Zero(free_count, free_count);
  if (iterate.has_full_rank) {
    const Matrix inverse = decomposition.matrixR()
                               .topLeftCorner(rank, rank)
                               .triangularView<Eigen::Upper>()
                               .solve(Matrix::Identity(rank, rank));
    covariance =
        decomposition.colsPermutation() * (inverse * inverse.transpose()) * decomposition.colsPermutation().transpose();
  }
  for (Index i = 0; i < free_count; ++i) {
    const Index at = free[std::size_t(i)];
    iterate.step[at] = lengths[i] > 0 ? step[i] / lengths[i] : 0;
    for (Index j = 0; j < free_count; ++j) {
      if (iterate.has_full_rank) {
        iterate.covariance(at, free[std::size_t(j)]) = covariance(i, j) / (lengths[i] * lengths[j]);
      }
    }
  }
}

/// The iterate, or nothing if the model has no finite value and slope.
std::optional<Iterate> evaluate(const LeastSquaresProblem& problem, const Vector& parameters) {
  Iterate iterate;
  iterate.parameters = parameters;
  iterate.residuals.resize(Index(problem.residual_count));
  iterate.jacobian.resize(iterate.residuals.size(), parameters.size());
  const auto span = [](auto& values) { return std::span(values.data(), std::size_t(values.size())); };
  if (!problem.evaluate(span(parameters), span(iterate.residuals), span(iterate.jacobian)) ||
      !iterate.residuals.allFinite() || !iterate.jacobian.allFinite()) {
    return std::nullopt;
  }
  solve_linear(problem, iterate);
  return iterate;
}

/// The parameters after a fraction of the step, within the bounds.
Vector stepped(const LeastSquaresProblem& problem, const Iterate& iterate, double fraction) {
  Vector parameters = iterate.parameters + fraction * iterate.step;
  for (std::size_t k = 0; k < problem.lower.size(); ++k) {
    parameters[Index(k)] = std::max(parameters[Index(k)], problem.lower[k]);
  }
  for (std::size_t k = 0; k < problem.upper.size(); ++k) {
    parameters[Index(k)] = std::min(parameters[Index(k)], problem.upper[k]);
  }
  return parameters;
}

/// Gauss-Newton, with each step halved until the objective falls, until it hardly falls. Nothing if no step lets it
/// fall.
std::optional<Iterate> approach(const LeastSquaresProblem& problem, Iterate iterate, std::size_t& iterations) {
  constexpr int kMaxSteps = 100, kMaxHalvings = 12;
  constexpr double kHardly = 1e-6;
  for (int i = 0; i < kMaxSteps && !has_converged(iterate); ++i) {
    std::optional<Iterate> next;
    double fraction = 1;
    for (int halvings = 0; halvings <= kMaxHalvings && !next; ++halvings, fraction /= 2) {
      next = evaluate(problem, stepped(problem, iterate, fraction));
      ++iterations;
      if (next && !(next->objective() < iterate.objective())) next.reset();
    }
    if (!next) return std::nullopt;
    const bool is_near = next->objective() >= (1 - kHardly) * iterate.objective();
    iterate = *std::move(next);
    if (is_near) break;
  }
  return iterate;
}

/// Gauss-Newton to the last digits. Near the optimum the slope still distinguishes two iterates when the objective no
/// longer does. A descent that needs a smaller objective, like approach() and Ceres, stops with half the digits.
Iterate polish(const LeastSquaresProblem& problem, Iterate iterate, std::size_t& iterations) {
  for (int i = 0; i < 60; ++i) {
    auto next = evaluate(problem, stepped(problem, iterate, 1));
    ++iterations;
    if (!next || !(next->projection < iterate.projection) || !(next->objective() <= iterate.objective() * (1 + 1e-9))) {
      break;
    }
    iterate = *std::move(next);
  }
  return iterate;
}

/// The end of Ceres's descent from some parameters, polished; nothing if the model has no value there.
std::optional<Iterate> descend(const LeastSquaresProblem& problem, Vector parameters,
                               const ceres::Solver::Options& options, std::size_t& iterations) {
  CostFunction cost(problem, std::size_t(parameters.size()));
  ceres::Problem::Options problem_options;
  problem_options.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ceres::Problem ceres_problem(problem_options);
  ceres_problem.AddResidualBlock(&cost, nullptr, parameters.data());
  for (std::size_t i = 0; i < problem.lower.size(); ++i) {
    if (std::isfinite(problem.lower[i])) {
      ceres_problem.SetParameterLowerBound(parameters.data(), int(i), problem.lower[i]);
    }
  }
  for (std::size_t i = 0; i < problem.upper.size(); ++i) {
    if (std::isfinite(problem.upper[i])) {
      ceres_problem.SetParameterUpperBound(parameters.data(), int(i), problem.upper[i]);
    }
  }
  ceres::Solver::Summary summary;
  ceres::Solve(options, &ceres_problem, &summary);
  iterations += summary.iterations.size();
  auto iterate = evaluate(problem, parameters);
  return iterate ? polish(problem, *std::move(iterate), iterations) : iterate;
}

ceres::Solver::Options solver_options() {
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.logging_type = ceres::SILENT;
  options.max_num_iterations = 2000;
  options.max_num_consecutive_invalid_steps =
      options.max_num_iterations;  // beyond which Ceres writes to standard error
  options.function_tolerance = 1e-15;
  options.gradient_tolerance = 0;
  options.parameter_tolerance = 1e-14;
  return options;
}

/// A wide trust region takes long steps and may leap onto a plateau far away; a narrow one creeps down its first slope,
/// and may end in the first hollow.
std::vector<ceres::Solver::Options> strategies(Descent descent) {
  std::vector<ceres::Solver::Options> result{solver_options()};
  if (descent == Descent::one) {
    result.back().function_tolerance = 1e-8;
    return result;
  }
  result.push_back(solver_options());
  result.back().initial_trust_region_radius = 1e-4;
  return result;
}

}  // namespace

LeastSquaresFit fit_least_squares(const LeastSquaresProblem& problem, std::span<const double> start, Descent descent) {
  assert(problem.residual_count > 0 && !start.empty());
  LeastSquaresFit fit;
  fit.parameters.assign(start.begin(), start.end());
  const Vector first = Eigen::Map<const Vector>(start.data(), Index(start.size()));
  std::optional<Iterate> best = evaluate(problem, first);
  if (!best) return fit;
  if (descent == Descent::one) {
    if (auto near = approach(problem, *best, fit.iterations)) best = polish(problem, *std::move(near), fit.iterations);
  }
  if (descent == Descent::several || !has_converged(*best)) {
    for (const auto& options : strategies(descent)) {
      const auto end = descend(problem, first, options, fit.iterations);
      if (end && end->objective() < best->objective()) best = end;
    }
  }
  fit.parameters.assign(best->parameters.begin(), best->parameters.end());
  fit.objective = best->objective();
  fit.gradient = best->gradient;
  fit.status = has_converged(*best) ? LeastSquaresStatus::converged : LeastSquaresStatus::stalled;
  const Index free_count = std::count(best->is_held.begin(), best->is_held.end(), false);
  const Index degrees_of_freedom = best->residuals.size() - free_count;
  if (best->has_full_rank && degrees_of_freedom > 0) {
    const Matrix covariance = best->covariance * (2 * fit.objective / double(degrees_of_freedom));
    fit.covariance.emplace(covariance.data(), covariance.data() + covariance.size());
  }
  return fit;
}

}  // namespace litfog
