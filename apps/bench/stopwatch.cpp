// SPDX-License-Identifier: Apache-2.0
#include "bench/stopwatch.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <array>
#include <ctime>
#include <string>

#include "measure/quantile.h"

namespace litfog::bench {
namespace {

/// Keeps the time per pass of each repetition, in the order of registration. Prints nothing.
class Collector : public benchmark::BenchmarkReporter {
 public:
  explicit Collector(std::size_t count) : seconds_(count) {}

  bool ReportContext(const Context&) override { return true; }

  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration) continue;
      seconds_[std::size_t(run.family_index)].push_back(run.cpu_accumulated_time / double(run.iterations));
    }
  }

  const std::vector<double>& seconds(std::size_t i) const { return seconds_[i]; }

 private:
  std::vector<std::vector<double>> seconds_;
};

double milliseconds_of(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return double(time.tv_sec) * 1e3 + double(time.tv_nsec) * 1e-6;
}

}  // namespace

std::vector<Timing> time_passes(const std::vector<TimedPass>& passes, const StopwatchSettings& settings,
                                command::Progress& progress) {
  std::string name = "litfog-bench";
  std::string interleaving = "--benchmark_enable_random_interleaving=true";
  std::array<char*, 3> arguments{name.data(), interleaving.data(), nullptr};
  int count = 2;
  benchmark::Initialize(&count, arguments.data());
  int runs = 0;  // the repetitions, and the runs that find how many passes fill the time
  const auto on_run = [&] {
    progress.show(
        fmt::format("timing: run {} of about {}", ++runs, passes.size() * std::size_t(settings.repetitions + 2)));
  };
  for (std::size_t i = 0; i < passes.size(); ++i) {
    const auto measure = [&pass = passes[i], &on_run](benchmark::State& state) {
      on_run();
      for ([[maybe_unused]] auto _ : state) {
        pass.run();
        benchmark::ClobberMemory();
      }
    };
    benchmark::RegisterBenchmark(std::to_string(i).c_str(), measure)
        ->Repetitions(settings.repetitions)
        ->MinTime(settings.least_seconds);
  }
  Collector collector(passes.size());
  benchmark::RunSpecifiedBenchmarks(&collector);
  benchmark::ClearRegisteredBenchmarks();

  std::vector<Timing> timings;
  for (std::size_t i = 0; i < passes.size(); ++i) {
    std::vector<double> times;
    for (const double seconds : collector.seconds(i)) {
      times.push_back(seconds * 1e9 / double(passes[i].items));
    }
    timings.push_back({measure::quantile(times, 0.5), measure::quantile(times, 0.9) - measure::quantile(times, 0.1)});
  }
  return timings;
}

double thread_milliseconds() { return milliseconds_of(CLOCK_THREAD_CPUTIME_ID); }

double process_milliseconds() { return milliseconds_of(CLOCK_PROCESS_CPUTIME_ID); }

}  // namespace litfog::bench
