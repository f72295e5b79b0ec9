// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bench/result.h"

namespace litfog::bench {

/// C, L and Q from falloff tables of 20 samples, by litfog and by Ceres as one would first use them.
/// Columns:
///
/// problem       exact: samples of a light of 1 to 1,000 m; noise-2 and noise-20: off by 2 and 20 per cent (standard
///               deviation); outliers: 2 %, and one in eight off by a factor of 2 to 20; clamped: C < 1, 2 %; far: a
///               light of 10 to 1,000 km, 2 %; near: of 1 to 100 mm, 2 %
/// method        litfog (fit_attenuation, proof of the global optimum included); ceres (bounds at 0, default options,
///               start C = L = Q = 1)
/// tables        of the problem
/// ms            processor time of one thread a table: the median over repetitions
/// ms_spread     from its 10th to its 90th percentile
/// objective     mean over the tables
/// solved_share  fraction of the tables whose objective is within 0.1 % of the optimum's (and 1e-20)
/// digits        the fewest over the tables in which ln attenuation agrees with the optimum's at all samples, up to 17
///
/// The optimum is the best found by any method, brought to 50 digits and certified there.
///
/// quick  fewer tables and shorter runs, to test that it works
Result measure_fit(bool quick);

}  // namespace litfog::bench
