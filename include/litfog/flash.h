// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "litfog/value_error.h"

namespace litfog {

inline constexpr std::size_t kMaxFlashes = 8;      ///< per period
inline constexpr double kMaxFlashPeriod = 3600;    ///< seconds
inline constexpr double kMaxFlashIntensity = 1e6;  ///< a flash of a microsecond has 2e5 times its effective intensity
inline constexpr double kMaxFlashSeconds = 1e9;    ///< largest time; doubles there are 1.2e-7 s apart

/// One flash of a lamp, in each period.
struct SingleFlash {
  double start = 0;      ///< seconds from the period's start, not before the end of the previous flash
  double duration = 0;   ///< seconds, > 0 and no mere rounding of the start; it ends within the period
  double intensity = 1;  ///< (0, kMaxFlashIntensity]: multiplies the light's colour

  friend bool operator==(const SingleFlash&, const SingleFlash&) = default;
};

/// How a lamp flashes: it is dark except in its flashes, which recur in each period. The first period begins at time 0.
struct Flash {
  double period = 0;                               ///< seconds, (0, kMaxFlashPeriod]
  std::size_t count = 0;                           ///< flashes per period, at most kMaxFlashes; 0: a steady lamp
  std::array<SingleFlash, kMaxFlashes> flashes{};  ///< the first `count` are in use

  friend bool operator==(const Flash&, const Flash&) = default;
};

/// What is wrong with a flash, or nothing; nothing is wrong with a steady lamp's. The functions below need one that
/// passes.
std::optional<ValueError> find_error(const Flash& flash);

/// The factor on the light's colour at a time: a flash's intensity from its start until just before start + duration;
/// 0 between flashes; 1 for a steady lamp. The time within the period is exact: nothing drifts.
///
/// seconds  [0, kMaxFlashSeconds]
double flash_at(const Flash& flash, double seconds);

/// The largest factor on the light's colour at any time.
double largest_flash(const Flash& flash);

}  // namespace litfog
