// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "litfog/attenuation.h"
#include "litfog/fit/target_error.h"

namespace litfog {

/// One row of a falloff table.
struct AttenuationSample {
  double range = 0;        ///< metres: 0, or 1e-30 to 1e30; greater than that of the sample before
  double attenuation = 1;  ///< fraction of the near brightness: [1e-100, 1]
  double weight = 1;       ///< 0 (left out), or 1e-100 to 1e100; relative to the other samples' weights
};

/// Which attenuation meets an extent, if there are no samples.
enum class AttenuationFamily {
  quadratic,  ///< L = 0
  linear,     ///< Q = 0
  mixed,      ///< L r = Q r^2 at the extent: of all mixes, the terms there have the least sum of squares
};

/// The goal of an attenuation fit: an extent, or samples (two or more), or an extent and samples.
struct AttenuationTarget {
  double threshold = kDefaultThreshold;  ///< [1e-100, 1): the attenuation at the extent
  std::optional<double> extent = {};     ///< metres, 1e-30 to 1e30; met exactly
  std::optional<double> constant = {};   ///< C: 0 to 1e100. Absent: free with samples, 1 without
  std::vector<AttenuationSample> samples = {};
  AttenuationFamily family = AttenuationFamily::quadratic;  ///< for an extent without samples; otherwise not read
  /// For measured tables with outliers: a residual costs its square only up to a scale s that follows from the table
  /// (AttenuationFit::loss_scale), and beyond it linearly (soft L1: 2 s^2 (sqrt(1 + (residual / s)^2) - 1)).
  bool is_robust = false;
};

/// What is wrong with a target, or nothing.
std::optional<TargetError> find_error(const AttenuationTarget& target);

/// What makes a light one of so many candela.
struct LightEnd {
  double size;    ///< its colour is multiplied by this
  double extent;  ///< metres, of its attenuation
};

/// Largest relative error of candela(light) of a light that was made by compute_end and fit_attenuation.
inline constexpr double kLightEndMaxError = 2e-15;

/// Where a light ends that gives a stated illuminance there in clear air. With an attenuation of C = 1 and L = 0 that
/// has the extent, and a colour c times size, candela(light) is c times the candela:
///   size = lux / (kWhiteLux threshold), extent = sqrt((1 / threshold - 1) / Q) for Q = kWhiteLux size / candela
///
/// candela    > 0, on the light's axis
/// lux        > 0, on the axis at the extent
/// threshold  (0, 1): attenuation at the extent
/// max error  kLightEndMaxError                                                             (attenuation_fit_test.cpp)
LightEnd compute_end(double candela, double lux, double threshold);

enum class AttenuationFitStatus {
  optimal,     ///< no attenuation that meets the extent (and constant) has a smaller objective by more than 1e-7 of it
  unproven,    ///< the best found; the search ended before it could rule out a better one
  infeasible,  ///< no attenuation meets the target: the best fit of it; the sentence says what could be met
};

/// The constraint that holds an attenuation's coefficients.
enum class AttenuationConstraint { extent, constant_given, constant_zero, linear_zero, quadratic_zero };

/// "extent", "constant given", "constant = 0", ...
const char* name_of(AttenuationConstraint constraint);

/// A fit and how good it is. A residual is ln a(range) - ln attenuation, as in the objective. An error is
/// a(range) / attenuation - 1: 0.01 is 1 % too bright.
struct AttenuationFit {
  Attenuation attenuation = {};
  double threshold = kDefaultThreshold;
  AttenuationFitStatus status = AttenuationFitStatus::optimal;
  std::string sentence = {};           ///< the outcome as text
  double objective = 0;                ///< sum of weight * residual^2 (robust: weight * soft L1)
  double rms_error = 0;                ///< root of the weighted mean of error^2
  double largest_error = 0;            ///< signed: the largest in magnitude of the samples with weight
  std::vector<double> residuals = {};  ///< one a sample
  /// Robust: the scale s = 1.345 * 1.4826 * the median of the n - p largest |residuals| of the n samples, p the free
  /// coefficients, about the fit of (nearly) least absolute residuals; at least 1e-6. Infinite otherwise.
  double loss_scale = std::numeric_limits<double>::infinity();
  std::vector<AttenuationConstraint> active = {};
  /// Covariance of constant, linear, quadratic, row by row, from the residuals' own variance; 0 for what a constraint
  /// holds. Absent where the samples do not identify them or leave no degrees of freedom.
  std::optional<std::array<double, 9>> covariance = {};
  /// Largest violation of the conditions of optimality. A slope is in units of what it would be if all residuals
  /// were 1.
  double kkt_residual = 0;
  std::size_t iterations = 0;  ///< descent steps
  std::size_t boxes = 0;       ///< boxes of coefficients examined for the proof that no others are better
  double milliseconds = 0;
};

/// Fits an attenuation to a target: the global minimum of sum w (ln a(r) - ln attenuation)^2 over all C, L, Q >= 0, not
/// all 0, that have the extent and the constant given.
///
/// search      starts from the linear least squares of 1 / a, descends by damped Newton steps, and rules out all other
///             coefficients by branch and bound
/// ties        where several attenuations are optimal (two samples and no extent, a table of ones), one with C = 1 if
///             there is one
/// extent      C is at most (1 - 2^-20) / threshold; at 1 / threshold the light would end at 0
/// infeasible  if the constant leaves no extent, or if a sample is out of reach of every attenuation with that extent
///             and constant: by more than 0.1 %, and by more than three times the error (rms or the sample's own) of
///             the best attenuation without extent and constant
/// max error   the extent 1e-12 relative; C, L and Q 9 digits of the exact optimum where the samples identify them
///                                                                                        (attenuation_fit_test.cpp)
/// throws      std::invalid_argument with the sentence of find_error(target)
AttenuationFit fit_attenuation(const AttenuationTarget& target);

}  // namespace litfog
