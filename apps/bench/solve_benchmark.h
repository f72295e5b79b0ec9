// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bench/result.h"

namespace litfog::bench {

/// Time against error of every method to find a light's fog colour intensity, over the mix of light_mix.h. Columns:
///
/// method         hales-N, hales-N-simd, boost-brent, exact, batch, memory-copy;
///                batch-uncached (exp fog only) and memory-copy-uncached over more lights than the caches hold
/// precision      float or double, of arguments, computation and result
/// fog            exp or exp2; empty for the copies
/// ns_per_light   processor time of one thread: the median over repetitions
/// ns_spread      from its 10th to its 90th percentile
/// max_ulp, mean_ulp              error in units of the precision's last place at the 50-digit reference
/// max_error_255, mean_error_255  error in steps of an 8-bit colour channel; empty for the copies, as the former two
///
/// quick  fewer lights, shorter runs: to see that it works
Result measure_solve(bool quick);

}  // namespace litfog::bench
