// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "litfog/cone.h"
#include "litfog/fit/target_error.h"
#include "litfog/photometry/axial_beam.h"

namespace litfog {

/// A light's intensity at an angle from its axis.
struct ConeSample {
  double angle = 0;      ///< radians from the axis, [0, pi]
  double intensity = 1;  ///< >= 0, in any unit: a fit divides it by the largest one with weight
  double weight = 1;     ///< 0 (left out), or 1e-100 to 1e100
};

/// Samples of weight 1 from a measured beam's profile about an axis (litfog/photometry/axial_beam.h).
std::vector<ConeSample> cone_samples(const std::vector<AxialSample>& profile);

/// The largest intensity of the samples with weight; 0 without any.
double peak_of(const std::vector<ConeSample>& samples);

/// The parameters that a fit of a profile determines, in the order of its covariance; none for a profile that is not
/// fitted.
std::span<const ConeParameter> fitted_parameters(ConeProfile profile);

/// The goal of a cone fit: samples, a beam angle, a field angle, or all of these.
struct ConeTarget {
  /// The only profile to fit. Absent: all that can be fitted.
  std::optional<ConeProfile> profile = std::nullopt;
  /// Where the light ends, radians from the axis: the cut-off of all profiles to fit, within the range of each. Absent:
  /// free.
  std::optional<double> half_angle = std::nullopt;
  std::optional<double> beam_angle = std::nullopt;   ///< full angle at 50 % of the peak, radians, (0, 2 pi]
  std::optional<double> field_angle = std::nullopt;  ///< full angle at 10 %, above the beam angle
  /// By increasing angle; at least two with weight unless an angle is given.
  std::vector<ConeSample> samples = {};
};

/// What is wrong with a target, or nothing.
std::optional<TargetError> find_error(const ConeTarget& target);

enum class ConeFitStatus {
  optimal,   ///< no cone of the profile has an objective smaller by more than 0.1 %
  unproven,  ///< the best cone found; the search ended before it could rule out a better one
};

/// A fitted profile, its quality, and its proof.
struct ConeProfileFit {
  Cone cone;
  double objective = 0;            ///< sum of weight * (cone - I / I_max)^2 over the samples
  double lower_bound = 0;          ///< no cone of this profile has a smaller objective
  double rms = 0;                  ///< sqrt(objective / sum of weights)
  double largest_error = 0;        ///< signed: the cone - I / I_max that is largest in magnitude
  double largest_error_angle = 0;  ///< that sample's angle
  /// Flux of the cone / flux of the samples - 1, over the angles that the samples cover, interpolated linearly. Absent
  /// without samples.
  std::optional<double> flux_error = std::nullopt;
  /// Angle where the cone falls to 50 % / the target's - 1. The target's angle is stated, or it is where the linearly
  /// interpolated samples first fall to 50 % beyond their peak. Absent if they do not.
  std::optional<double> beam_angle_error = std::nullopt;
  std::optional<double> field_angle_error = std::nullopt;  ///< the same at 10 %
  /// Largest |cosine| between the residuals and the effect of a free parameter; 0 at a smooth optimum, and if the
  /// residuals are only rounding.
  double kkt_residual = 0;
  /// Covariance of fitted_parameters(), from the residuals' own variance; 0 for a parameter that is given or at a
  /// bound, and beyond their number; of a cosine cone, at the cut-off of the least objective. Absent if the samples do
  /// not identify them (fit_cone) or leave no degrees of freedom.
  std::optional<std::array<std::array<double, 2>, 2>> covariance = std::nullopt;
  /// The objective is the same for every cut-off in (first, second], which the samples leave open. If the samples
  /// determine the cut-off, both are equal to it.
  std::array<double, 2> cutoff_range = {0, 0};
  std::size_t iterations = 0;  ///< in all descents
  std::size_t boxes = 0;       ///< boxes of parameters that the proof of optimality examined
  ConeFitStatus status = ConeFitStatus::optimal;
};

/// The fits of one or all profiles, and which is best.
struct ConeFit {
  std::vector<ConeProfileFit> profiles = {};  ///< in the order of ConeProfile
  std::size_t best_index = 0;                 ///< the smallest objective; the first among equal or exact ones
  double milliseconds = 0;

  const ConeProfileFit& best() const { return profiles[best_index]; }
};

/// Fits a cone to a target: the global minimum of sum of weight * (cone_at(cos u) - I / I_max)^2 over all cones of a
/// profile. A beam angle adds the sample 0.5 at half the angle, a field angle the sample 0.1, each of weight 1; either
/// adds the sample 1 on the axis.
///
/// search       branch and bound: a cone rises with each of its parameters, so two corners of a box of parameters bound
///              it at every sample. The best cone found is refined by least squares
///
/// Where the samples leave a choice:
/// cosine       half_angle is where the cone falls to 0.05 % (which shows no edge: 1.6 of 255 in sRGB), or half-way in
///              a gap between samples beyond, or between a sample and 90 degrees: the first of these at which the
///              objective is at most 0.04 % above the smallest. If the samples end the beam before, it is half-way
///              between the last that is best lit and the first that is best dark. Without a lit sample off the axis
///              the exponent is 0
/// smoothstep   with fewer samples in the edge than free angles, the softest possible edge: the smallest inner that the
///              samples at full intensity allow
///
/// returns      each profile, and which is best; covariance is absent where these rules made the choice
/// max error    of an optimal fit, objective 0.1 % above the least, or 1e-20 of sum of weight * (I / I_max)^2
///                                                                                              (cone_fit_test.cpp)
/// throws       std::invalid_argument with the sentence of find_error(target)
ConeFit fit_cone(const ConeTarget& target);

}  // namespace litfog
