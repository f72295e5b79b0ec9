// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "fit/light_fit.h"

namespace litfog::fit {

/// What the author of a light may want to know or change, a sentence each, the gravest first. A change of the command
/// line is fitted before it is advised: it is named with the error that it leaves, where that is smaller.
///
/// choices  those of the fit
/// read     the fit's target by other choices
std::vector<std::string> advice_on(const LightFit& fit, const FitChoices& choices,
                                   const std::function<LightTarget(const FitChoices&)>& read);

}  // namespace litfog::fit
