// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fit/falloff.h"

namespace litfog {

/// A minimum, and how far it is known to be global.
struct FalloffSearch {
  FalloffMinimum minimum;
  std::size_t boxes = 0;
  bool is_proven = false;  ///< no coefficients have an objective smaller by more than 1e-7 of it
};

/// The global minimum, from a local one, by branch and bound over boxes of coefficients.
FalloffSearch search(const Falloff& falloff, const FalloffMinimum& local);

}  // namespace litfog
