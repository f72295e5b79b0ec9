// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "command/plot.h"
#include "fit/light_fit.h"

namespace litfog::fit {

/// Targets and fits, and below them the errors, over range and over angle; and the beam as a polar diagram, above its
/// spread over the turn. Of several lights, one in each colour, the profile that each fit chose.
///
/// fits  at least one
command::Figure fit_figure(const std::vector<const LightFit*>& fits);

}  // namespace litfog::fit
