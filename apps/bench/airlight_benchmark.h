// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bench/result.h"

namespace litfog::bench {

/// Time against error of every method to find a lamp's airlight along a ray, over the mixes of airlight_mix.h. Columns:
///
/// method         march, march-clipped, litfog, reference; over the inverse-square mix: arctangent, pegoraro-2009 and
///                sun-2005 (both with the lamp's leg), litfog, reference
/// nodes          steps of a march; empty for the other methods
/// fog            exp or exp2
/// lights         point, g-0.85, droplets, layers, any or inverse-square: the mix
/// lamp_leg       k: 1 where the fog dims the light on its way from the lamp, too, else 0
/// ns_per_ray     processor time of one thread: the median over repetitions
/// ns_spread      from its 10th to its 90th percentile
/// max_error_255  largest error in steps of an 8-bit colour channel, relative where the airlight is above 1; empty for
///                the reference, as the next
/// p99_relative   99th percentile of the relative error
///
/// quick  fewer rays, shorter runs: to see that it works
Result measure_airlight(bool quick);

}  // namespace litfog::bench
