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

/// An hour of a simulator at 60 steps a second, as fast as it goes: in each step the visibility moves, lights flash,
/// are moved, switched, taken away and added as others. Columns:
///
/// lights, kinds, steps
/// ms_per_step, ms_99, ms_worst  processor time of a step, the shorter of two runs that do the same: the median, the
///                               99th percentile, the longest
/// resident_mib, grown_mib       memory of the process in the end, and how much came after a twentieth of the steps
/// max_deviation_255             largest difference of an intensity in the end from its exact value, in 1/255
///
/// quick  fewer lights and steps: to see that it works
Result measure_load(bool quick);

}  // namespace litfog::bench
