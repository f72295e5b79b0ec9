// SPDX-License-Identifier: Apache-2.0
#include "bench/benchmarks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bench/light_mix.h"
#include "bench/rival.h"
#include "bench/stopwatch.h"
#include "command/progress.h"
#include "litfog/batch.h"
#include "litfog/solve.h"
#include "reference/reference_solver.h"

namespace litfog::bench {
namespace {

using test::Digits50;

struct Scale {
  std::size_t lights;      ///< per pass: more than branch predictors learn, fewer than the second cache holds
  std::size_t references;  ///< number of lights with references: the first ones
  std::size_t uncached;    ///< lights per pass through memory
  StopwatchSettings stopwatch;
};
constexpr Scale kFull{4096, 2000, 4'000'000, {15, 0.02}};
constexpr Scale kQuick{512, 200, 100'000, {3, 0.0005}};

constexpr std::uint64_t kSeed = 20'040'601;
constexpr int kSamples[] = {16, 64, 256, 1024};

template <typename Real>
constexpr const char* kPrecisionName = sizeof(Real) == sizeof(float) ? "float" : "double";

struct Errors {
  double max_ulp = 0;
  double mean_ulp = 0;
  double max_255 = 0;
  double mean_255 = 0;
};

template <typename Real>
Errors errors_of(const std::vector<Real>& computed, const std::vector<Digits50>& references) {
  Errors errors;
  for (std::size_t i = 0; i < references.size(); ++i) {
    const double ulp = test::ulp_error(computed[i], references[i]);
    const double steps = 255 * std::abs(double(Digits50(computed[i]) - references[i]));
    errors.max_ulp = std::max(errors.max_ulp, ulp);
    errors.max_255 = std::max(errors.max_255, steps);
    errors.mean_ulp += ulp / double(references.size());
    errors.mean_255 += steps / double(references.size());
  }
  return errors;
}

/// The lights of one fog in one precision, and their reference results.
template <typename Real>
struct Problem {
  FogMode mode;
  LightColumns<Real> lights;
  std::vector<Digits50> references;
  std::vector<Real> intensity;  ///< written by the passes

  Problem(FogMode fog_mode, LightColumns<Real> columns, std::size_t reference_count, command::Progress& progress)
      : mode(fog_mode), lights(std::move(columns)), intensity(lights.size()) {
    for (std::size_t i = 0; i < reference_count; ++i) {
      const Attenuation attenuation{lights.constant[i], lights.linear[i], lights.quadratic[i]};
      references.push_back(
          test::solve_reference(attenuation, Fog{mode, lights.density[i]}, lights.threshold[i]).intensity);
      progress.show(
          fmt::format("references, {} {}: {} of {}", name_of(mode), kPrecisionName<Real>, i + 1, reference_count));
    }
  }
};

/// The look of a method in the chart: a point with a label.
struct Look {
  std::string label;
  command::LabelPlace place;
  int color;
};

/// Hales's sampling, drawn as one line over the numbers of samples.
struct Sampling {
  int samples;
  bool is_simd;
};

/// A method for the intensity of all lights of a problem.
struct Method {
  std::string name;
  std::string precision;
  std::optional<FogMode> fog;  ///< none: it solves nothing
  TimedPass pass;
  std::function<Errors()> errors = {};  ///< call after a pass; empty if it solves nothing
  double stated_ulp = std::numeric_limits<double>::infinity();
  std::optional<Look> look = {};
  std::optional<Sampling> sampling = {};
};

/// A method and its measurements.
struct Measurement {
  Method method;
  Timing timing;
  std::optional<Errors> errors;  ///< none if it solves nothing
};

/// A pass that calls a function light by light.
template <typename Real, typename Solve>
Method light_by_light(const std::string& name, Problem<Real>& problem, const Solve& solve) {
  const auto run = [&problem, solve] {
    for (std::size_t i = 0; i < problem.lights.size(); ++i) {
      problem.intensity[i] =
          solve(problem.lights.attenuation(i), BasicFog<Real>{problem.mode, problem.lights.density[i]},
                problem.lights.threshold[i]);
    }
  };
  return {name, kPrecisionName<Real>, problem.mode, {problem.lights.size(), run}, [&problem] {
            return errors_of(problem.intensity, problem.references);
          }};
}

/// A pass that solves all lights by one call.
template <typename Real>
Method at_once(const std::string& name, Problem<Real>& problem, const std::function<void()>& run) {
  return {name, kPrecisionName<Real>, problem.mode, {problem.lights.size(), run}, [&problem] {
            return errors_of(problem.intensity, problem.references);
          }};
}

template <typename Real>
Method batch(const std::string& name, Problem<Real>& problem) {
  return at_once(name, problem, [&problem] {
    solve_fog_intensities(problem.mode, problem.lights.view(), BasicBatchSolutions<Real>{problem.intensity});
  });
}

constexpr const char* kCopyName = "memory-copy";

/// The floor: moves as many bytes as the batch, which reads five columns and writes one. Copying three columns reads
/// three and writes three.
template <typename Real>
Method memory_copy(const std::string& name, std::size_t lights) {
  // Shared, since passes are copied.
  const auto from = std::make_shared<std::vector<Real>>(3 * lights, Real(1));
  const auto to = std::make_shared<std::vector<Real>>(3 * lights);
  const auto run = [from, to] { std::memcpy(to->data(), from->data(), to->size() * sizeof(Real)); };
  return {name, kPrecisionName<Real>, std::nullopt, {lights, run}};
}

std::vector<Method> methods_of(Problem<double>& problem, Problem<float>& problem_f) {
  std::vector<Method> methods;
  const auto add = [&](Method method, Look look, double stated_ulp = std::numeric_limits<double>::infinity()) {
    method.look = std::move(look);
    method.stated_ulp = stated_ulp;
    methods.push_back(std::move(method));
  };
  for (const int samples : kSamples) {
    methods.push_back(light_by_light(fmt::format("hales-{}", samples), problem,
                                     [samples](const Attenuation& attenuation, const Fog& fog, double threshold) {
                                       return sample_fog_intensity(attenuation, fog, threshold, samples).intensity;
                                     }));
    methods.back().sampling = {samples, false};
  }
  for (const int samples : kSamples) {
    methods.push_back(at_once(fmt::format("hales-{}-simd", samples), problem_f, [&problem_f, samples] {
      sample_fog_intensities(problem_f.mode, problem_f.lights.view(), samples, problem_f.intensity);
    }));
    methods.back().sampling = {samples, true};
  }
  add(light_by_light("boost-brent", problem, brent_intensity), {"Brent (Boost.Math)", command::LabelPlace::below, 4});
  add(light_by_light("exact", problem,
                     [](const Attenuation& attenuation, const Fog& fog, double threshold) {
                       return solve_fog_intensity(attenuation, fog, threshold).intensity;
                     }),
      {"litfog, double", command::LabelPlace::right, 2}, kIntensityMaxUlp<double>);
  add(light_by_light("exact", problem_f,
                     [](const AttenuationF& attenuation, const FogF& fog, float threshold) {
                       return solve_fog_intensity(attenuation, fog, threshold).intensity;
                     }),
      {"litfog, float", command::LabelPlace::above, 2}, kIntensityMaxUlp<float>);
  add(batch("batch", problem), {"litfog batch, double", command::LabelPlace::below, 0}, kBatchIntensityMaxUlp);
  add(batch("batch", problem_f), {"litfog batch, float", command::LabelPlace::below, 0}, kBatchIntensityMaxUlp);
  return methods;
}

command::Chart draw_pareto(FogMode fog, const std::vector<Measurement>& measurements) {
  command::Chart chart{.title = fmt::format("{} fog", name_of(fog)),
                       .x = {"processor time of one thread per light (ns)", true, 0.05, 5e4},
                       .y = {"largest error of the intensity (1/255)", true, 1e-16, 1e4},
                       .key = command::KeyPlace::none};
  command::Series scalar_sampling{.style = command::SeriesStyle::line_and_points, .color = 1};
  command::Series simd_sampling{.style = command::SeriesStyle::line_and_points, .color = 6};
  for (const auto& [method, timing, errors] : measurements) {
    const double time = timing.median;
    if (method.name == kCopyName) {
      const bool is_float = method.precision == kPrecisionName<float>;
      const command::PlotPoint label{time, 1e-9, is_float ? "" : "copy of a light's bytes: float, double"};
      chart.series.push_back({.points = {{time, chart.y.least}, label, {time, chart.y.most}},
                              .style = command::SeriesStyle::dashes,
                              .color = 7});
    }
    if (method.fog != fog) continue;
    const double error = std::max(errors->max_255, chart.y.least);  // 0 is drawn at the axis's end
    if (method.sampling) {
      const auto [samples, is_simd] = *method.sampling;
      command::Series& series = is_simd ? simd_sampling : scalar_sampling;
      const bool is_first = series.points.empty();
      const char* const line = !is_first ? "" : is_simd ? "Hales SIMD, N = " : "Hales, N = ";
      series.points.push_back({time, error, fmt::format("{}{}", line, samples),
                               is_first ? command::LabelPlace::above : command::LabelPlace::right});
    }
    if (method.look) {
      chart.series.push_back({.points = {{time, error, method.look->label, method.look->place}},
                              .style = command::SeriesStyle::points,
                              .color = method.look->color});
    }
  }
  chart.series.push_back(scalar_sampling);
  chart.series.push_back(simd_sampling);
  return chart;
}

command::Table make_table(const std::vector<Measurement>& measurements) {
  command::Table table{{"method", "precision", "fog", "ns_per_light", "ns_spread", "max_ulp", "mean_ulp",
                        "max_error_255", "mean_error_255"}};
  using Cell = command::Table::Cell;
  for (const auto& measurement : measurements) {
    const Method& method = measurement.method;
    const auto error = [&errors = measurement.errors](double Errors::*member) {
      return errors ? Cell((*errors).*member) : Cell(std::monostate());
    };
    table.rows.push_back({method.name, method.precision, method.fog ? Cell(name_of(*method.fog)) : std::monostate(),
                          measurement.timing.median, measurement.timing.spread, error(&Errors::max_ulp),
                          error(&Errors::mean_ulp), error(&Errors::max_255), error(&Errors::mean_255)});
  }
  return table;
}

}  // namespace

Result measure_solve(bool quick) {
  const Scale& scale = quick ? kQuick : kFull;
  command::Progress progress;
  std::vector<Problem<double>> problems;
  std::vector<Problem<float>> problems_f;
  for (const FogMode mode : {FogMode::exp, FogMode::exp2}) {
    const auto lights = draw_light_mix(mode, scale.lights, kSeed + (mode == FogMode::exp ? 0 : 1));
    const auto lights_f = to_float(lights);
    problems.emplace_back(mode, lights, scale.references, progress);
    problems_f.emplace_back(mode, lights_f, scale.references, progress);
  }
  Problem<double> uncached(FogMode::exp, repeated(problems[0].lights, scale.uncached), 0, progress);
  Problem<float> uncached_f(FogMode::exp, repeated(problems_f[0].lights, scale.uncached), 0, progress);
  uncached.references = problems[0].references;
  uncached_f.references = problems_f[0].references;

  std::vector<Method> methods;
  for (std::size_t i = 0; i < problems.size(); ++i) {
    for (Method& method : methods_of(problems[i], problems_f[i])) methods.push_back(std::move(method));
  }
  methods.push_back(batch("batch-uncached", uncached));
  methods.back().stated_ulp = kBatchIntensityMaxUlp;
  methods.push_back(batch("batch-uncached", uncached_f));
  methods.back().stated_ulp = kBatchIntensityMaxUlp;
  methods.push_back(memory_copy<double>(kCopyName, scale.lights));
  methods.push_back(memory_copy<float>(kCopyName, scale.lights));
  methods.push_back(memory_copy<double>("memory-copy-uncached", scale.uncached));
  methods.push_back(memory_copy<float>("memory-copy-uncached", scale.uncached));

  std::vector<TimedPass> passes;
  for (const Method& method : methods) passes.push_back(method.pass);
  const auto timings = time_passes(passes, scale.stopwatch, progress);

  Result result;
  std::vector<Measurement> measurements;
  for (std::size_t i = 0; i < methods.size(); ++i) {
    const Method& method = methods[i];
    measurements.push_back({method, timings[i], std::nullopt});
    if (!method.errors) continue;
    method.pass.run();  // restores this method's results, which the last one timed has overwritten
    const Errors errors = method.errors();
    measurements.back().errors = errors;
    if (!(errors.max_ulp <= method.stated_ulp)) {
      result.failures.push_back(fmt::format("{} {} {}: error = {} ulp: must be at most {}", method.name,
                                            method.precision, name_of(*method.fog), errors.max_ulp, method.stated_ulp));
    }
  }
  result.table = make_table(measurements);
  result.figure = {.title = "Fog colour intensity of a light: time against error",
                   .charts = {draw_pareto(FogMode::exp, measurements), draw_pareto(FogMode::exp2, measurements)},
                   .columns = 2,
                   .width = 1300,
                   .height = 600};
  return result;
}

}  // namespace litfog::bench
