// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bench/result.h"

namespace litfog::bench {

/// A visibility that sinks from 10,000 to 50 m and rises again, step by step, over many lights of few kinds, all of
/// them carried and switched on. Columns:
///
/// method         updater (FogUpdater with its default budget), updater-no-skip (with budget 0), batch-of-all (no
///                updater: the float batch over every light, each result stored among the light's other
///                parameters)
/// fog            exp or exp2
/// lights, kinds, steps
/// ms_per_step    processor time of one thread: the median over the steps
/// ms_spread      from its 10th to its 90th percentile
/// bytes_per_step what has to be uploaded to the GPU after a step, the fog included: the most of all steps
/// skipped_share  fraction of the lights whose kind was not solved, mean over the steps
/// max_deviation_255  largest difference of colour times intensity from solving everything exactly, in 1/255
///
/// quick  fewer lights and steps: to see that it works
Result measure_update(bool quick);

}  // namespace litfog::bench
