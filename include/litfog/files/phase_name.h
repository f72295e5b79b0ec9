// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include "litfog/phase.h"

namespace litfog::files {

inline constexpr const char* kPhaseRule =
    "must be isotropic, rayleigh, hg:G with G in (-1, 1), draine:G,ALPHA with ALPHA in [0, 1e6], a sum of two of these "
    "whose weights add up to 1, such as 0.7*hg:0.8+0.3*hg:-0.2, or droplets:D with D of 5 to 50 micrometres";

/// Largest difference from 1 of the sum of a name's two weights.
inline constexpr double kPhaseWeightTolerance = 1e-9;

/// The phase function of a name that follows kPhaseRule; nothing for other names. For a sum, Phase::weight is the first
/// weight.
std::optional<Phase> phase_named(std::string_view name);

}  // namespace litfog::files
