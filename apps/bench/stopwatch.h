// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "command/progress.h"

namespace litfog::bench {

/// Something to time: one pass over its items. What it computes it must store where others can see it.
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

/// Times the passes with Google Benchmark, the repetitions of all in random order, so that a slow spell of the machine
/// hits no pass alone. Shows how many runs are done.
std::vector<Timing> time_passes(const std::vector<TimedPass>& passes, const StopwatchSettings& settings,
                                command::Progress& progress);

/// Processor time that the calling thread has taken so far.
double thread_milliseconds();
/// That all threads of the process have taken so far, a software rasteriser's included.
double process_milliseconds();

}  // namespace litfog::bench
