// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "fit/light_fit.h"

namespace litfog::fit {

/// A fitted light as a text to read: targets, what was fitted, how well and how that is known.
std::string format_data_sheet(const LightFit& fit);

}  // namespace litfog::fit
