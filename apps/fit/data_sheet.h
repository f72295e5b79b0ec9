// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "fit/outcome.h"

namespace litfog::fit {

/// A fitted light in the words of its maker, in at most 15 lines: the verdict, what the data state beside what the
/// light gives, and advice.
///
/// outcome  one with a fit
std::string format_report(const Outcome& outcome);

/// All else that is known: how figures were derived, what was fitted, how well, how that is known, and all advice.
std::string format_details(const Outcome& outcome);

/// What two lights give, side by side.
std::string format_comparison(const Outcome& one, const Outcome& other);

}  // namespace litfog::fit
