// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include "litfog/phase.h"

namespace litfog::files {

inline constexpr const char* kPhaseRule =
    "must be isotropic, hg:G with G in (-1, 1) or droplets:D with D of 5 to 50 micrometres";

/// The phase function of a name that follows kPhaseRule; nothing for other names.
std::optional<Phase> phase_named(std::string_view name);

}  // namespace litfog::files
