// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "litfog/solve.h"

namespace litfog {

/// solve_fog_intensity with a single exponential, for arguments that are 0 or within 2^+-100, except limit cases. Gives
/// the same digits on every processor; nothing for peaks so deep in the fog that no light returns. Internal.
std::optional<FogIntensity> solve_by_series(const Attenuation& attenuation, const Fog& fog, double threshold);

}  // namespace litfog
