// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "command/plot.h"
#include "fit/light_fit.h"

namespace litfog::fit {

/// Targets, fits and what lies between them, over range and over angle.
command::Figure fit_figure(const LightFit& fit);

}  // namespace litfog::fit
