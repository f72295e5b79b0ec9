// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace litfog::command {

/// The value below which a share of the values lies, between neighbours in proportion: share 0.5 is the median.
///
/// values  not empty
/// share   [0, 1]
double quantile(std::vector<double> values, double share);

}  // namespace litfog::command
