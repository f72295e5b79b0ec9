// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "litfog/solve.h"

namespace litfog::bench {

/// The fog colour intensity by a general minimiser of one variable, Boost.Math's brent_find_minima, over [0, extent] as
/// one would use it: to 26 bits, the most that its documentation recommends for double; the extent's own value
/// included. Arguments as solve_fog_intensity, not checked.
double brent_intensity(const Attenuation& attenuation, const Fog& fog, double threshold);

}  // namespace litfog::bench
