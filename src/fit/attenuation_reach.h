// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "litfog/fit/attenuation_fit.h"

namespace litfog {

/// The distance of a sample, in ln attenuation, from the values that attenuations with the target's extent and constant
/// reach at its range; 0 within.
double distance_from_reach(const AttenuationTarget& target, const AttenuationSample& sample);

/// Why a target's constant is out of reach, with the largest that is not, rounded down:
/// "constant 30 cannot be reached with an extent of 450 m at threshold 0.1: from 0 to 9.99999 can".
std::string describe_constant_reach(const AttenuationTarget& target, double largest);

/// Why a sample is out of reach, and the ranges at which its attenuation could be reached:
/// "attenuation 0.5 at 40 m cannot be reached with an extent of 100 m: between 0 and 31.62 m can".
/// Bounds are rounded inwards, so that both named ranges can be reached.
std::string describe_reach(const AttenuationTarget& target, const AttenuationSample& sample);

}  // namespace litfog
