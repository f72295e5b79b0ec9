// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "fit/cone_point.h"
#include "litfog/cone.h"
#include "litfog/fit/cone_fit.h"

// Internal.

namespace litfog {

/// The figures of a cone against its target, whatever found it.
///
/// points  points_of(target)
ConeProfileFit assess(const Cone& cone, const std::vector<ConePoint>& points, const ConeTarget& target);

}  // namespace litfog
