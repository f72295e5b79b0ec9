// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>

namespace litfog {

/// Step from a beam's last lit angle to the dark beyond it in a table or profile, radians: 0.01 degrees.
inline constexpr double kDarkEdge = std::numbers::pi / 18000;

}  // namespace litfog
