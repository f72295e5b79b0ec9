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
  double attenuation = 1;  ///< share of the near brightness: [1e-100, 1]
  double weight = 1;       ///< 0 (left out), or 1e-100 to 1e100; relative to the other samples' weights
};

/// What an extent without samples is met with.
enum class AttenuationFamily {
  quadratic,  ///< L = 0
  linear,     ///< Q = 0
  mixed,      ///< L r and Q r^2 are equal at the extent: of all mixes, the one whose terms there have the least sum of
              ///< squares
};

/// What a light's range attenuation shall be. Well posed are: an extent; an extent and samples; two samples or more.
struct AttenuationTarget {
  double threshold = kDefaultThreshold;  ///< [1e-100, 1): the attenuation at the extent
  std::optional<double> extent = {};     ///< metres, 1e-30 to 1e30; met exactly
  std::optional<double> constant = {};  ///< C, if it is given: 0 to 1e100. Else it is free where there are samples, and
                                        ///< 1 where there are none
  std::vector<AttenuationSample> samples = {};
  AttenuationFamily family =
      AttenuationFamily::quadratic;  ///< of an extent without samples; not read where there are some
  /// For measured tables with outliers: residuals count as their squares only up to a scale s that the table itself
  /// gives, and beyond it linearly (soft L1: 2 s^2 (sqrt(1 + (residual / s)^2) - 1)).
  bool is_robust = false;
};

/// What is wrong with a target, or nothing.
std::optional<TargetError> check(const AttenuationTarget& target);

enum class AttenuationFitStatus {
  optimal,     ///< no attenuation that meets the extent (and constant) has a smaller objective by more than 1e-7 of it
  unproven,    ///< the best found; the search ended before it could rule out a better one
  infeasible,  ///< the same best fit, but of a target that no attenuation meets; the sentence says what could be met
};

/// What holds an attenuation's coefficients where they are.
enum class AttenuationConstraint { extent, constant_given, constant_zero, linear_zero, quadratic_zero };

/// "extent", "constant given", "constant = 0", ...
const char* name_of(AttenuationConstraint constraint);

/// A fit and how good it is. A residual is ln a(range) - ln attenuation: 0.01 is 1 % too bright.
struct AttenuationFit {
  Attenuation attenuation = {};
  double threshold = kDefaultThreshold;
  AttenuationFitStatus status = AttenuationFitStatus::optimal;
  std::string sentence = {};           ///< the outcome in words
  double objective = 0;                ///< sum of weight * residual^2 (robust: * soft L1 of it)
  double rms = 0;                      ///< root of the weighted mean of residual^2
  double largest_residual = 0;         ///< by amount, of the samples with weight
  std::vector<double> residuals = {};  ///< a sample each
  /// Robust: the scale s = 1.345 * 1.4826 * the median of the n - p largest |residuals| of the n samples, p the free
  /// coefficients, about the fit of (nearly) least absolute residuals; at least 1e-6. Infinite otherwise.
  double loss_scale = std::numeric_limits<double>::infinity();
  std::vector<AttenuationConstraint> active = {};
  /// Of constant, linear, quadratic, row by row, from the residuals' own variance; 0 for what a constraint holds.
  /// Absent where the samples do not identify them, or none is to spare.
  std::optional<std::array<double, 9>> covariance = {};
  /// Largest violation of the conditions of optimality, in units of residuals: how far off balance they are left.
  double kkt_residual = 0;
  std::size_t iterations = 0;  ///< of the descents
  std::size_t boxes = 0;       ///< of coefficients that were ruled out to prove that no better ones are elsewhere
  double milliseconds = 0;
};

/// The attenuation that minimises sum w (ln a(r) - ln attenuation)^2 over all C, L, Q >= 0, not all 0, that have the
/// extent and the constant given: the global minimum. It starts from the reciprocal's linear least squares, descends by
/// Ceres, ends with Newton steps, and rules out every other place by branch and bound, in which a box of coefficients
/// is done with as soon as the objective is convex in it.
///
/// Where several attenuations are optimal (two samples and no extent, a table of ones), one with C = 1 is returned if
/// there is one. Where an extent is given, C is at most 1 - 2^-20 of 1/threshold, where the light would end at 0.
///
/// A target is infeasible where the constant leaves no extent, or where a sample lies out of reach of every attenuation
/// with that extent and constant: by more than 0.1 %, and by more than three times what the table (rms) or the sample
/// itself is off the table's own best attenuation without extent and constant.
///
/// max error  the extent 1e-12 relative; C, L and Q 9 digits of the exact optimum where the samples identify them
///                                                                                        (attenuation_fit_test.cpp)
/// throws     std::invalid_argument with the sentence of check(target)
AttenuationFit fit_attenuation(const AttenuationTarget& target);

}  // namespace litfog
