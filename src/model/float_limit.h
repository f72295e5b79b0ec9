// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <limits>

namespace litfog {

// Programs that compute in floats write numbers beyond closed limits: float(pi / 2) is above pi / 2, and a sum of
// fractions ends at 1.0000001. A closed limit accepts such a number as the limit itself. An open limit does not.

/// Whether a number lies in [low, high], or beyond by a float's rounding: by 2^-23 of that limit, the step of floats
/// from 1 on. Beyond 0, which floats hold exactly, nothing does. False for NaN.
constexpr bool is_within(double x, double low, double high) {
  constexpr double kStep = std::numeric_limits<float>::epsilon();
  const bool is_above = x >= low || low - x <= kStep * (low < 0 ? -low : low);
  const bool is_below = x <= high || x - high <= kStep * (high < 0 ? -high : high);
  return is_above && is_below;
}

/// Clamps a number that is_within() to [low, high]; any other number stays as it is, for a check to refuse.
constexpr double snapped(double x, double low, double high) {
  return is_within(x, low, high) ? std::clamp(x, low, high) : x;
}

/// Whether a number differs from a limit by a float's rounding only.
constexpr bool is_float_of(double limit, double x) { return is_within(x, limit, limit); }

}  // namespace litfog
