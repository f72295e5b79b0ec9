// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>

namespace litfog::test {

inline constexpr double kDegree = std::numbers::pi / 180;  ///< radians

}  // namespace litfog::test
