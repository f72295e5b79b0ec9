// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "command/progress.h"

namespace litfog::bench {

/// Work to time: one pass over its items. It must store its results where the compiler cannot drop them.
struct TimedPass {
  std::size_t items;
  std::function<void()> run;
};

/// Processor time of the calling thread for one item, in nanoseconds, over the repetitions.
struct Timing {
  double median;
  double spread;  ///< from the 10th to the 90th percentile
};

struct StopwatchSettings {
  int repetitions;
  double least_seconds;  ///< a repetition runs as many passes as fill this time
};

/// Times the passes with Google Benchmark, the repetitions of all in random order, so that a slow phase of the machine
/// hits no pass alone. Shows the number of finished runs.
std::vector<Timing> time_passes(const std::vector<TimedPass>& passes, const StopwatchSettings& settings,
                                command::Progress& progress);

/// Processor time of the calling thread so far.
double thread_milliseconds();
/// Processor time of all threads of the process so far, including a software rasteriser's.
double process_milliseconds();

}  // namespace litfog::bench
