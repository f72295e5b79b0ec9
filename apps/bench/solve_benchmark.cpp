// SPDX-License-Identifier: Apache-2.0
#include "bench/solve_benchmark.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "bench/light_mix.h"
#include "bench/rival.h"
#include "bench/sampled_batch.h"
#include "bench/stopwatch.h"
#include "command/progress.h"
#include "litfog/batch.h"
#include "litfog/solve.h"
#include "reference/reference_solver.h"

namespace litfog::bench {
namespace {

using test::Digits50;

struct Scale {
  std::size_t lights;      ///< of a pass: more than branch predictors learn, less than the second cache holds
  std::size_t references;  ///< the first of them
  std::size_t uncached;    ///< lights of a pass through memory
  StopwatchSettings stopwatch;
};
constexpr Scale kFull{4096, 2000, 4'000'000, {15, 0.02}};
constexpr Scale kQuick{512, 200, 100'000, {3, 0.0005}};

constexpr std::uint64_t kSeed = 20'040'601;
constexpr int kSamples[] = {16, 64, 256, 1024};

const char* name_of(FogMode mode) { return mode == FogMode::exp ? "exp" : "exp2"; }
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
    const double steps = 255 * std::abs(static_cast<double>(Digits50(computed[i]) - references[i]));
    errors.max_ulp = std::max(errors.max_ulp, ulp);
    errors.max_255 = std::max(errors.max_255, steps);
    errors.mean_ulp += ulp / static_cast<double>(references.size());
    errors.mean_255 += steps / static_cast<double>(references.size());
  }
  return errors;
}

/// The lights of one fog in one precision, and what is right for them.
template <typename Real>
struct Problem {
  FogMode mode;
  LightColumns<Real> lights;
  std::vector<Digits50> references;
  std::vector<Real> intensity;  ///< where the passes store

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

/// A row of the table before it is measured.
struct Method {
  std::string name;
  std::string precision;
  std::string fog;
  TimedPass pass;
  std::function<Errors()> errors;  ///< after a pass; empty where the pass solves nothing
  double stated_ulp = std::numeric_limits<double>::infinity();
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
  return {name, kPrecisionName<Real>, name_of(problem.mode), {problem.lights.size(), run}, [&problem] {
            return errors_of(problem.intensity, problem.references);
          }};
}

/// A pass that solves all lights by one call.
template <typename Real>
Method at_once(const std::string& name, Problem<Real>& problem, const std::function<void()>& run) {
  return {name, kPrecisionName<Real>, name_of(problem.mode), {problem.lights.size(), run}, [&problem] {
            return errors_of(problem.intensity, problem.references);
          }};
}

template <typename Real>
Method batch(const std::string& name, Problem<Real>& problem) {
  Method method = at_once(name, problem, [&problem] {
    solve_fog_intensities(problem.mode, problem.lights.view(), BasicBatchSolutions<Real>{problem.intensity});
  });
  method.stated_ulp = kBatchIntensityMaxUlp;
  return method;
}

/// The floor: as many bytes moved as the batch reads and writes. It reads five columns and writes one; copying three
/// columns reads three and writes three.
template <typename Real>
Method memory_copy(const std::string& name, std::size_t lights) {
  // Shared, since passes are copied.
  const auto from = std::make_shared<std::vector<Real>>(3 * lights, Real(1));
  const auto to = std::make_shared<std::vector<Real>>(3 * lights);
  const auto run = [from, to] { std::memcpy(to->data(), from->data(), to->size() * sizeof(Real)); };
  return {name, kPrecisionName<Real>, "", {lights, run}, {}};
}

std::vector<Method> methods_of(Problem<double>& problem, Problem<float>& problem_f) {
  std::vector<Method> methods;
  for (const int samples : kSamples) {
    methods.push_back(light_by_light(fmt::format("hales-{}", samples), problem,
                                     [samples](const Attenuation& attenuation, const Fog& fog, double threshold) {
                                       return sample_fog_intensity(attenuation, fog, threshold, samples).intensity;
                                     }));
  }
  for (const int samples : kSamples) {
    methods.push_back(at_once(fmt::format("hales-{}-simd", samples), problem_f, [&problem_f, samples] {
      sample_fog_intensities(problem_f.mode, problem_f.lights.view(), samples, problem_f.intensity);
    }));
  }
  methods.push_back(light_by_light("golden-section", problem, golden_section_intensity));
  methods.push_back(light_by_light("boost-brent", problem, brent_intensity));
  methods.push_back(light_by_light("exact", problem, [](const Attenuation& attenuation, const Fog& fog, double t) {
    return solve_fog_intensity(attenuation, fog, t).intensity;
  }));
  methods.back().stated_ulp = kIntensityMaxUlp<double>;
  methods.push_back(light_by_light("exact", problem_f, [](const AttenuationF& attenuation, const FogF& fog, float t) {
    return solve_fog_intensity(attenuation, fog, t).intensity;
  }));
  methods.back().stated_ulp = kIntensityMaxUlp<float>;
  methods.push_back(batch("batch", problem));
  methods.push_back(batch("batch", problem_f));
  return methods;
}

/// A method in the picture.
struct Look {
  std::string method;
  std::string precision;
  std::string label;
  command::LabelPlace place;
  int color;
};

command::Chart draw_pareto(const std::string& fog, const command::Table& table) {
  const std::vector<Look> looks{
      {"golden-section", "double", "golden section", command::LabelPlace::right, 3},
      {"boost-brent", "double", "Brent (Boost.Math)", command::LabelPlace::below, 4},
      {"exact", "double", "litfog, double", command::LabelPlace::right, 2},
      {"exact", "float", "litfog, float", command::LabelPlace::above, 2},
      {"batch", "double", "litfog batch, double", command::LabelPlace::below, 0},
      {"batch", "float", "litfog batch, float", command::LabelPlace::above, 0},
  };
  command::Chart chart{.title = fog + " fog",
                       .x = {"processor time of one thread per light (ns)", true, 0.05, 5e4},
                       .y = {"largest error of the intensity (1/255)", true, 1e-16, 1e4},
                       .key = command::KeyPlace::none};
  command::Series scalar_sampling{.style = command::SeriesStyle::line_and_points, .color = 1};
  command::Series simd_sampling{.style = command::SeriesStyle::line_and_points, .color = 6};
  const auto text = [](const command::Table::Cell& cell) { return std::get<std::string>(cell); };
  for (const auto& row : table.rows) {
    const std::string method = text(row[0]);
    const double time = std::get<double>(row[3]);
    if (method == "memory-copy") {
      const bool is_float = text(row[1]) == "float";
      const command::PlotPoint label{time, 1e-9, is_float ? "" : "copy of a light's bytes: float, double"};
      chart.series.push_back({.points = {{time, chart.y.least}, label, {time, chart.y.most}},
                              .style = command::SeriesStyle::dashes,
                              .color = 7});
    }
    if (!std::holds_alternative<std::string>(row[2]) || text(row[2]) != fog) continue;
    const double error = std::max(std::get<double>(row[7]), chart.y.least);  // exactly 0 stands at the axis's end
    if (method.starts_with("hales-")) {
      const bool is_simd = method.ends_with("-simd");
      command::Series& series = is_simd ? simd_sampling : scalar_sampling;
      const std::string samples = method.substr(6, method.find('-', 6) - 6);
      const bool is_first = series.points.empty();
      series.points.push_back({time, error, (is_first ? is_simd ? "Hales SIMD, N = " : "Hales, N = " : "") + samples,
                               is_first ? command::LabelPlace::above : command::LabelPlace::right});
    }
    for (const Look& look : looks) {
      if (method != look.method || text(row[1]) != look.precision) continue;
      chart.series.push_back({.points = {{time, error, look.label, look.place}},
                              .style = command::SeriesStyle::points,
                              .color = look.color});
    }
  }
  chart.series.push_back(scalar_sampling);
  chart.series.push_back(simd_sampling);
  return chart;
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
  methods.push_back(batch("batch-uncached", uncached_f));
  methods.push_back(memory_copy<double>("memory-copy", scale.lights));
  methods.push_back(memory_copy<float>("memory-copy", scale.lights));
  methods.push_back(memory_copy<double>("memory-copy-uncached", scale.uncached));
  methods.push_back(memory_copy<float>("memory-copy-uncached", scale.uncached));

  std::vector<TimedPass> passes;
  for (const Method& method : methods) passes.push_back(method.pass);
  int runs = 0;
  const auto timings = time_passes(passes, scale.stopwatch, [&] {
    progress.show(fmt::format("timing: run {} of about {}", ++runs,
                              methods.size() * static_cast<std::size_t>(scale.stopwatch.repetitions + 2)));
  });

  Result result;
  result.table.columns = {"method",  "precision", "fog",           "ns_per_light",  "ns_spread",
                          "max_ulp", "mean_ulp",  "max_error_255", "mean_error_255"};
  for (std::size_t i = 0; i < methods.size(); ++i) {
    const Method& method = methods[i];
    auto& row = result.table.rows.emplace_back();
    row = {method.name, method.precision};
    row.push_back(method.fog.empty() ? command::Table::Cell(std::monostate()) : method.fog);
    row.emplace_back(timings[i].median);
    row.emplace_back(timings[i].spread);
    if (!method.errors) {
      row.resize(result.table.columns.size(), command::Table::Cell(std::monostate()));
      continue;
    }
    method.pass.run();  // the results of this method, not of the one timed last
    const Errors errors = method.errors();
    for (const double error : {errors.max_ulp, errors.mean_ulp, errors.max_255, errors.mean_255}) {
      row.emplace_back(error);
    }
    if (!(errors.max_ulp <= method.stated_ulp)) {
      result.failures.push_back(fmt::format("{} {} {}: error = {} ulp: must be at most {}", method.name,
                                            method.precision, method.fog, errors.max_ulp, method.stated_ulp));
    }
  }
  result.figure = {.title = "Fog colour intensity of a light: time against error",
                   .charts = {draw_pareto("exp", result.table), draw_pareto("exp2", result.table)},
                   .columns = 2,
                   .width = 1300,
                   .height = 600};
  return result;
}

}  // namespace litfog::bench
