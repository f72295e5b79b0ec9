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
  double range = 0;        ///< metres: 0, or 1e-30 to 1e30; greater than the previous sample's
  double attenuation = 1;  ///< fraction of the near brightness: [1e-100, 1]
  double weight = 1;       ///< 0 (left out), or 1e-100 to 1e100; relative to the other samples' weights
};

/// Which attenuation meets an extent without samples.
enum class AttenuationFamily {
  quadratic,  ///< L = 0
  linear,     ///< Q = 0
  mixed,      ///< L r = Q r^2 at the extent, which minimises the sum of squares of the two terms
};

/// The goal of an attenuation fit: an extent, or samples (two or more), or an extent and samples.
struct AttenuationTarget {
  double threshold = kDefaultThreshold;  ///< [1e-100, 1): the attenuation at the extent
  std::optional<double> extent = {};     ///< metres, 1e-30 to 1e30; met exactly
  std::optional<double> constant = {};   ///< C: 0 to 1e100. Absent: free with samples, 1 without
  std::vector<AttenuationSample> samples = {};
  AttenuationFamily family = AttenuationFamily::quadratic;  ///< for an extent without samples; otherwise ignored
  /// For measured tables with outliers: the loss is quadratic up to a scale s that follows from the table
  /// (AttenuationFit::loss_scale), and linear beyond it (soft L1: 2 s^2 (sqrt(1 + (residual / s)^2) - 1)).
  bool is_robust = false;
};

/// What is wrong with a target, or nothing.
std::optional<TargetError> find_error(const AttenuationTarget& target);

/// Colour factor and extent that give a light its candela.
struct LightEnd {
  double size;    ///< factor on its colour
  double extent;  ///< its attenuation's, metres
};

/// Largest relative error of candela(light) for a light made by compute_end and fit_attenuation.
inline constexpr double kLightEndMaxError = 2e-15;

/// The extent at which a light gives a stated illuminance in clear air. With C = 1, L = 0 and this extent, and a colour
/// of c times size, candela(light) is c times the candela:
///   size = lux / (kWhiteLux threshold), extent = sqrt((1 / threshold - 1) / Q) for Q = kWhiteLux size / candela
///
/// candela    > 0, on the light's axis
/// lux        > 0, on the axis at the extent
/// threshold  (0, 1): attenuation at the extent
/// max error  kLightEndMaxError                                                             (attenuation_fit_test.cpp)
LightEnd compute_end(double candela, double lux, double threshold);

enum class AttenuationFitStatus {
  /// No attenuation that meets the extent (and constant) lowers the objective by more than 1e-7 of it, or than 1e-20 of
  /// the sum of weights.
  optimal,
  unproven,    ///< the best found; the search ended before it could rule out a better one
  infeasible,  ///< no attenuation meets the target; this is the best fit, and the sentence says what could be met
};

/// A constraint on an attenuation's coefficients.
enum class AttenuationConstraint { extent, constant_given, constant_zero, linear_zero, quadratic_zero };

/// "extent", "constant given", "constant = 0", ...
const char* name_of(AttenuationConstraint constraint);

/// A fit and its quality. A residual is ln a(range) - ln attenuation, as in the objective. An error is
/// a(range) / attenuation - 1: 0.01 is 1 % too bright.
struct AttenuationFit {
  Attenuation attenuation = {};
  double threshold = kDefaultThreshold;
  AttenuationFitStatus status = AttenuationFitStatus::optimal;
  std::string sentence = {};           ///< the outcome as text
  double objective = 0;                ///< sum of weight * residual^2 (robust: weight * soft L1)
  double rms_error = 0;                ///< root of the weighted mean of error^2
  double largest_error = 0;            ///< signed, the largest in magnitude among samples with weight
  std::vector<double> residuals = {};  ///< one per sample
  /// Robust: the scale s = 1.345 * 1.4826 * the median of the n - p largest |residuals|, with n samples and p free
  /// coefficients, about the fit with (nearly) the least absolute residuals; at least 1e-6. Infinite otherwise.
  double loss_scale = std::numeric_limits<double>::infinity();
  std::vector<AttenuationConstraint> active = {};
  /// Covariance of constant, linear, quadratic, row by row, from the residuals' own variance; 0 for constrained
  /// coefficients. Absent if the samples do not identify them or leave no degrees of freedom.
  std::optional<std::array<double, 9>> covariance = {};
  /// Largest violation of the optimality (KKT) conditions. Slopes are relative to what they would be if all residuals
  /// were 1.
  double kkt_residual = 0;
  std::size_t iterations = 0;  ///< descent steps
  std::size_t boxes = 0;       ///< boxes of coefficients that the proof of optimality examined
  double milliseconds = 0;
};

/// Fits an attenuation to a target: the global minimum of sum w (ln a(r) - ln attenuation)^2 over all C, L, Q >= 0, not
/// all 0, with the given extent and constant.
///
/// search      starts from the linear least squares of 1 / a, descends by damped Newton steps, and rules out all other
///             coefficients by branch and bound
/// ties        if several attenuations are optimal (two samples and no extent, a table of ones), one with C = 1 is
///             preferred
/// extent      C is at most (1 - 2^-20) / threshold; at 1 / threshold the light would end at 0
/// infeasible  if the constant leaves no extent, or if no attenuation with that extent and constant comes near a
///             sample: to within 0.1 %, or three times the error (rms or the sample's own) of the best attenuation
///             without extent and constant
/// max error   the extent 1e-12 relative; C, L and Q to 9 digits of the exact optimum if the samples identify them
///                                                                                        (attenuation_fit_test.cpp)
/// throws      std::invalid_argument with the sentence of find_error(target)
AttenuationFit fit_attenuation(const AttenuationTarget& target);

}  // namespace litfog
