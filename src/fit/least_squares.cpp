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

/// The problem as Ceres asks for it.
class CostFunction final : public ceres::CostFunction {
 public:
  CostFunction(const LeastSquaresProblem& problem, std::size_t parameter_count)
      : problem_(problem), parameter_count_(parameter_count) {
    set_num_residuals(static_cast<int>(problem.residual_count));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(parameter_count));
  }

  bool Evaluate(const double* const* parameters, double* residuals, double** jacobians) const override {
    double* jacobian = jacobians != nullptr ? jacobians[0] : nullptr;
    const std::size_t size = jacobian != nullptr ? problem_.residual_count * parameter_count_ : 0;
    // Ceres takes no for an answer, but calls a value that is not finite an error and writes a page about it.
    return problem_.evaluate({parameters[0], parameter_count_}, {residuals, problem_.residual_count},
                             {jacobian, size}) &&
           std::all_of(residuals, residuals + problem_.residual_count, is_finite) &&
           std::all_of(jacobian, jacobian + size, is_finite);
  }

 private:
  const LeastSquaresProblem& problem_;
  std::size_t parameter_count_;
};

/// What is known of the problem at one place.
struct Place {
  Vector parameters;
  Vector residuals;
  Matrix jacobian;
  std::vector<bool> is_held;  ///< at a bound, and the objective falls beyond it
  Vector step;                ///< of Gauss and Newton, in the free parameters
  double reach = 0;           ///< length of the residuals' projection onto what the free parameters can do
  double gradient = 0;
  double relative_step = 0;  ///< both in what they do to the residuals
  bool has_full_rank = false;
  Matrix covariance;  ///< but for the variance

  double objective() const { return 0.5 * residuals.squaredNorm(); }
};

class Descender {
 public:
  Descender(const LeastSquaresProblem& problem, std::span<const double> start)
      : problem_(problem), start_(Eigen::Map<const Vector>(start.data(), static_cast<Index>(start.size()))) {}

  /// The place, or nothing where the model has no finite value and slope.
  std::optional<Place> look(const Vector& parameters) const {
    Place place;
    place.parameters = parameters;
    place.residuals.resize(static_cast<Index>(problem_.residual_count));
    place.jacobian.resize(place.residuals.size(), parameters.size());
    const auto span = [](auto& values) { return std::span(values.data(), static_cast<std::size_t>(values.size())); };
    if (!problem_.evaluate(span(parameters), span(place.residuals), span(place.jacobian)) ||
        !place.residuals.allFinite() || !place.jacobian.allFinite()) {
      return std::nullopt;
    }
    solve_linear(place);
    return place;
  }

  std::optional<Place> descend(const ceres::Solver::Options& options, std::size_t& iterations) const {
    Vector parameters = start_;
    CostFunction cost(problem_, static_cast<std::size_t>(parameters.size()));
    ceres::Problem::Options problem_options;
    problem_options.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    ceres::Problem ceres_problem(problem_options);
    ceres_problem.AddResidualBlock(&cost, nullptr, parameters.data());
    for (std::size_t i = 0; i < problem_.lower.size(); ++i) {
      if (std::isfinite(problem_.lower[i])) {
        ceres_problem.SetParameterLowerBound(parameters.data(), static_cast<int>(i), problem_.lower[i]);
      }
    }
    for (std::size_t i = 0; i < problem_.upper.size(); ++i) {
      if (std::isfinite(problem_.upper[i])) {
        ceres_problem.SetParameterUpperBound(parameters.data(), static_cast<int>(i), problem_.upper[i]);
      }
    }
    ceres::Solver::Summary summary;
    ceres::Solve(options, &ceres_problem, &summary);
    iterations += summary.iterations.size();
    auto place = look(parameters);
    return place ? polish(*place, iterations) : place;
  }

 private:
  bool is_at_lower(const Vector& parameters, Index i) const {
    const auto at = static_cast<std::size_t>(i);
    return at < problem_.lower.size() && parameters[i] <= problem_.lower[at];
  }
  bool is_at_upper(const Vector& parameters, Index i) const {
    const auto at = static_cast<std::size_t>(i);
    return at < problem_.upper.size() && parameters[i] >= problem_.upper[at];
  }

  /// Which parameters are free, and the linear least squares in them. Columns are brought to one length first: the
  /// rank must not depend on the parameters' units.
  void solve_linear(Place& place) const {
    const Vector slope = place.jacobian.transpose() * place.residuals;
    std::vector<Index> free;
    for (Index i = 0; i < place.parameters.size(); ++i) {
      const bool is_held =
          (is_at_lower(place.parameters, i) && slope[i] >= 0) || (is_at_upper(place.parameters, i) && slope[i] <= 0);
      place.is_held.push_back(is_held);
      if (!is_held) free.push_back(i);
    }
    const auto free_count = static_cast<Index>(free.size());
    place.step = Vector::Zero(place.parameters.size());
    place.covariance = Matrix::Zero(place.parameters.size(), place.parameters.size());
    place.has_full_rank = place.residuals.size() >= free_count;
    if (free_count == 0) return;

    Matrix columns(place.residuals.size(), free_count);
    Vector lengths(free_count);
    Vector scaled_parameters(free_count);
    for (Index i = 0; i < free_count; ++i) {
      const Index at = free[static_cast<std::size_t>(i)];
      const auto column = place.jacobian.col(at);
      lengths[i] = column.norm();
      columns.col(i) = lengths[i] > 0 ? Vector(column / lengths[i]) : Vector::Zero(columns.rows());
      scaled_parameters[i] = lengths[i] * place.parameters[at];
    }
    const double residual_length = place.residuals.norm();
    if (residual_length > 0) {
      place.gradient = (columns.transpose() * place.residuals).cwiseAbs().maxCoeff() / residual_length;
    }
    const Eigen::ColPivHouseholderQR<Matrix> decomposition(columns);
    const Index rank = decomposition.rank();
    place.has_full_rank = rank == free_count;
    place.reach = (decomposition.householderQ().adjoint() * place.residuals).head(rank).norm();
    const Vector step = -decomposition.solve(place.residuals);
    const double parameter_length = scaled_parameters.norm();
    place.relative_step = parameter_length > 0 ? step.norm() / parameter_length : step.norm();
    Matrix covariance = Matrix::Zero(free_count, free_count);
    if (place.has_full_rank) {
      const Matrix inverse = decomposition.matrixR()
                                 .topLeftCorner(rank, rank)
                                 .triangularView<Eigen::Upper>()
                                 .solve(Matrix::Identity(rank, rank));
      covariance = decomposition.colsPermutation() * (inverse * inverse.transpose()) *
                   decomposition.colsPermutation().transpose();
    }
    for (Index i = 0; i < free_count; ++i) {
      const Index at = free[std::size_t(i)];
      place.step[at] = lengths[i] > 0 ? step[i] / lengths[i] : 0;
      for (Index j = 0; j < free_count; ++j) {
        if (place.has_full_rank) {
          place.covariance(at, free[std::size_t(j)]) = covariance(i, j) / (lengths[i] * lengths[j]);
        }
      }
    }
  }

  /// Gauss-Newton to the last digits. Near the optimum the objective no longer tells two places apart, its slope does:
  /// a descent that asks for a smaller objective, as Ceres does, stops with half the digits.
  Place polish(Place place, std::size_t& iterations) const {
    for (int i = 0; i < 60; ++i) {
      Vector next = place.parameters + place.step;
      for (std::size_t k = 0; k < problem_.lower.size(); ++k)
        next[Index(k)] = std::max(next[Index(k)], problem_.lower[k]);
      for (std::size_t k = 0; k < problem_.upper.size(); ++k)
        next[Index(k)] = std::min(next[Index(k)], problem_.upper[k]);
      auto tried = look(next);
      ++iterations;
      if (!tried || !(tried->reach < place.reach) || !(tried->objective() <= place.objective() * (1 + 1e-9))) break;
      place = *std::move(tried);
    }
    return place;
  }

  const LeastSquaresProblem& problem_;
  Vector start_;
};

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

/// A wide trust region takes long steps and may leap onto a plateau far away; a narrow one creeps down the slope that
/// it starts on, and may end in the first hollow.
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
  const Descender descender(problem, start);
  std::optional<Place> best = descender.look(Eigen::Map<const Vector>(start.data(), Index(start.size())));
  if (!best) return fit;
  for (const auto& options : strategies(descent)) {
    const auto place = descender.descend(options, fit.iterations);
    if (place && place->objective() < best->objective()) best = place;
  }
  fit.parameters.assign(best->parameters.begin(), best->parameters.end());
  fit.objective = best->objective();
  fit.gradient = best->gradient;
  const bool has_converged = best->gradient <= 1e-6 || best->relative_step <= 1e-10;
  fit.status = has_converged ? LeastSquaresStatus::converged : LeastSquaresStatus::stalled;
  const Index free_count = std::count(best->is_held.begin(), best->is_held.end(), false);
  const Index spare = best->residuals.size() - free_count;
  if (best->has_full_rank && spare > 0) {
    const Matrix covariance = best->covariance * (2 * fit.objective / double(spare));
    fit.covariance.emplace(covariance.data(), covariance.data() + covariance.size());
  }
  return fit;
}

}  // namespace litfog
