// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <limits>

#include "litfog/fog.h"

// The ends of double's range and both fogs, for the tests that go over them.

namespace litfog::test {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kDenormMin = std::numeric_limits<double>::denorm_min();
inline constexpr double kMax = std::numeric_limits<double>::max();
inline constexpr std::array kModes{FogMode::exp, FogMode::exp2};

}  // namespace litfog::test
