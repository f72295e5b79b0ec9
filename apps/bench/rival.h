// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "litfog/solve.h"

namespace litfog::bench {

/// The fog colour intensity by general minimisers of one variable, over [0, extent] as one would use them, the extent's
/// own value included. In double; arguments as solve_fog_intensity, not checked.

/// Golden section to 1e-8 of the range: nearer, the value's rounding hides the slope (the square root of epsilon).
double golden_section_intensity(const Attenuation& attenuation, const Fog& fog, double threshold);

/// Boost.Math's brent_find_minima to 26 bits, the most that its documentation recommends for double.
double brent_intensity(const Attenuation& attenuation, const Fog& fog, double threshold);

}  // namespace litfog::bench
