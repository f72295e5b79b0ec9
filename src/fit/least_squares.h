// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ceres/jet.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

// Small dense least squares for the fits of this folder. Internal, so that no public header includes Ceres.

namespace litfog {

/// Computes residuals at the parameters and, if the jacobian is not empty, their derivatives, one row a residual.
/// Returns false if the model has no value: no descent goes there.
using ResidualFunction =
    std::function<bool(std::span<const double> parameters, std::span<double> residuals, std::span<double> jacobian)>;

/// Minimise 0.5 * sum of squared residuals over the parameters within their bounds.
struct LeastSquaresProblem {
  std::size_t residual_count = 0;  ///< >= 1
  ResidualFunction evaluate = {};
  std::vector<double> lower = {};  ///< one bound per parameter, -infinity for none; empty: no bounds
  std::vector<double> upper = {};
};

enum class Descent {
  one,      ///< Gauss-Newton, or Levenberg-Marquardt if that stalls: if a local optimum is enough
  several,  ///< the best result of different trust regions, for starts that may be far off
};

enum class LeastSquaresStatus {
  converged,  ///< gradient at most 1e-6, or the next step would change the parameters by less than 1e-10 of themselves
  stalled,    ///< no descent got farther, but `converged` does not hold: the parameters are the best found
  undefined,  ///< the model has no value at the start: the parameters are the start
};

struct LeastSquaresFit {
  std::vector<double> parameters = {};
  double objective = 0;  ///< 0.5 * sum of squared residuals
  double gradient = 0;   ///< largest |cosine| between the residuals and the effect of a parameter that is free to move;
                         ///< meaningless for residuals of mere rounding
  std::size_t iterations = 0;
  LeastSquaresStatus status = LeastSquaresStatus::undefined;
  /// Covariance of the parameters, row by row, with the residuals' own variance; 0 for parameters at a bound. Nothing
  /// if the data do not identify the parameters: a rank below the count of free parameters at the working precision, or
  /// no residual to spare.
  std::optional<std::vector<double>> covariance = std::nullopt;
};

/// start  one value per parameter, at least one, within the bounds
LeastSquaresFit fit_least_squares(const LeastSquaresProblem& problem, std::span<const double> start,
                                  Descent descent = Descent::several);

/// The ResidualFunction of a model written once for any scalar: model(const T* parameters, T* residuals).
template <std::size_t kParameters, typename Model>
ResidualFunction differentiate(const Model& model) {
  return [model](std::span<const double> parameters, std::span<double> residuals, std::span<double> jacobian) {
    if (jacobian.empty()) {
      model(parameters.data(), residuals.data());
      return true;
    }
    using Jet = ceres::Jet<double, int(kParameters)>;
    std::array<Jet, kParameters> variables;
    for (std::size_t i = 0; i < kParameters; ++i) variables[i] = Jet(parameters[i], int(i));
    std::vector<Jet> values(residuals.size());
    model(variables.data(), values.data());
    for (std::size_t i = 0; i < residuals.size(); ++i) {
      residuals[i] = values[i].a;
      std::copy_n(values[i].v.data(), kParameters, jacobian.data() + i * kParameters);
    }
    return true;
  };
}

}  // namespace litfog
