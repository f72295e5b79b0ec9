// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "fit/light_fit.h"

namespace litfog::fit {

/// What the author of a light may want to know or change, a sentence each.
std::vector<std::string> advice_on(const LightFit& fit);

}  // namespace litfog::fit
