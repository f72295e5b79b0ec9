// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fit/light_fit.h"
#include "fit/two_lights.h"

namespace litfog::fit {

/// How well a light follows its data, whatever the proof says: the best fit may be a bad one.
enum class Grade { good, fair, poor };

/// The largest errors, in magnitude, of a good and of a fair light. A light beyond the latter is poor.
struct GradeLimits {
  double range_rms;      ///< falloff table: fraction of the attenuation
  double range_largest;  ///< falloff table: fraction of the attenuation
  double cone_rms;       ///< fraction of the peak
  double flux;           ///< fraction of the data's
  double beam_angle;     ///< fraction of the 50 % angle
  double field_angle;    ///< fraction of the 10 % angle
  double asymmetry;      ///< rms fraction of the beam that no cone follows, or that two do not
  double peak;           ///< fraction of a stated peak, or of a luminaire's where it is largest
};
inline constexpr GradeLimits kGood{0.05, 0.15, 0.05, 0.1, 0.1, 0.15, 0.15, 0.15};
inline constexpr GradeLimits kFair{0.2, 0.5, 0.1, 0.33, 0.25, 0.4, 0.4, 0.33};

struct Verdict {
  Grade grade;
  std::string why;  ///< what keeps the light from a better grade; of a good one, its errors
};

/// A target that cannot be met is poor, a fit that is not shown to be the best is fair at most.
Verdict judge(const LightFit& fit);
Verdict judge(const TwoLights& lights);

const char* name_of(Grade grade);

/// The limits, for the help: a heading and a line an error.
std::string grade_table();

/// What the author of a light may want to know or change, a sentence each, the gravest first. A change of the command
/// line is fitted before it is advised: it is named with the error that it leaves, where that is smaller.
///
/// two      the lights in place of the fit's, if that was chosen
/// choices  those of the fit
/// read     the fit's target by other choices
std::vector<std::string> advice_on(const LightFit& fit, const std::optional<TwoLights>& two, const FitChoices& choices,
                                   const std::function<LightTarget(const FitChoices&)>& read);

}  // namespace litfog::fit
