// SPDX-License-Identifier: Apache-2.0
#include "bench/benchmarks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <list>
#include <optional>
#include <string>
#include <vector>

#include "bench/airlight_mix.h"
#include "bench/airlight_rival.h"
#include "bench/stopwatch.h"
#include "command/progress.h"
#include "measure/quantile.h"

namespace litfog::bench {
namespace {

using test::AirlightCase;

struct Scale {
  std::size_t rays;        ///< per mix
  std::size_t references;  ///< number timed by the reference: the first rays
  StopwatchSettings stopwatch;
};
constexpr Scale kFull{4000, 100, {15, 0.02}};
constexpr Scale kQuick{200, 20, {3, 0.0005}};

constexpr std::uint64_t kSeed = 20'050'731;
constexpr int kSteps[] = {16, 32, 64, 128, 256};

/// The rays of one mix, and their reference results.
struct Problem {
  AirlightMix mix;
  FogMode fog;
  LampLeg lamp_leg;
  std::vector<AirlightCase> rays;
  std::vector<double> references = {};
  std::vector<double> results = {};  ///< written by the passes

  Problem(AirlightMix which, FogMode fog_mode, LampLeg leg, std::size_t count)
      : mix(which), fog(fog_mode), lamp_leg(leg), rays(draw_airlight_mix(which, fog_mode, leg, count, kSeed)) {
    for (const AirlightCase& c : rays)
      references.push_back(reference_airlight(c.light, c.atmosphere, c.ray, c.lamp_leg));
    results.resize(count);
  }
};

/// A method to find the airlight of all rays of a problem.
struct Method {
  std::string name;
  std::optional<int> nodes;
  const Problem* problem;
  TimedPass pass;
};

struct Errors {
  double max_255;
  double p99_relative;
};

/// A method and its measurements.
struct Measurement {
  Method method;
  Timing timing;
  std::optional<Errors> errors;  ///< nothing for the reference
};

Errors errors_of(const Problem& problem) {
  double largest = 0;
  std::vector<double> relative;
  for (std::size_t i = 0; i < problem.references.size(); ++i) {
    const double error = std::abs(problem.results[i] - problem.references[i]);
    const double shown = error / std::max(problem.references[i], 1.0);
    largest = std::max(largest, std::isfinite(shown) ? shown : std::numeric_limits<double>::infinity());
    relative.push_back(error / problem.references[i]);
  }
  return {255 * largest, measure::quantile(relative, 0.99)};
}

constexpr const char* kReferenceName = "reference";
constexpr const char* kLitfogName = "litfog";

/// Every method that computes the airlight of a problem's lamps.
std::vector<Method> methods_of(Problem& problem, const SunTable& table, std::size_t references) {
  std::vector<Method> methods;
  const auto add = [&](const std::string& name, std::optional<int> nodes, std::size_t rays, const auto& compute) {
    const auto run = [&problem, rays, compute] {
      for (std::size_t i = 0; i < rays; ++i) problem.results[i] = compute(problem.rays[i]);
    };
    methods.push_back({name, nodes, &problem, {rays, run}});
  };
  const std::size_t all = problem.rays.size();
  if (problem.mix == AirlightMix::inverse_square) {
    add("arctangent", {}, all, arctangent_airlight);
    if (problem.lamp_leg == LampLeg::fogged) {
      add("pegoraro-2009", {}, all, pegoraro_airlight);
      add("sun-2005", {}, all, [&table](const AirlightCase& c) { return table.airlight(c); });
    }
  } else {
    for (const int steps : kSteps) {
      add("march", steps, all, [steps](const AirlightCase& c) { return march_airlight(c, steps); });
    }
    for (const int steps : kSteps) {
      add("march-clipped", steps, all, [steps](const AirlightCase& c) { return march_lit_airlight(c, steps); });
    }
  }
  add(kLitfogName, {}, all, [](const AirlightCase& c) { return airlight(c.light, c.atmosphere, c.ray, c.lamp_leg); });
  add(kReferenceName, {}, references,
      [](const AirlightCase& c) { return reference_airlight(c.light, c.atmosphere, c.ray, c.lamp_leg); });
  return methods;
}

/// Time against error over one mix in exp fog that also dims the lamp's leg: a line over the numbers of nodes, or a
/// point.
command::Chart draw_pareto(const std::string& title, AirlightMix mix, double least_error,
                           const std::vector<Measurement>& measurements) {
  command::Chart chart{.title = title,
                       .x = {"processor time of one thread per ray (ns)", true, 30, 3e4},
                       .y = {"largest error of the airlight (1/255)", true, least_error, 1e4},
                       .key = command::KeyPlace::bottom_left};
  for (const auto& [method, timing, errors] : measurements) {
    const Problem& problem = *method.problem;
    const bool is_shown = problem.mix == mix && problem.fog == FogMode::exp && problem.lamp_leg == LampLeg::fogged;
    if (!is_shown || !errors) continue;
    const bool goes_on = !chart.series.empty() && chart.series.back().name == method.name;
    if (!goes_on) {
      chart.series.push_back(
          {.name = method.name,
           .style = method.nodes ? command::SeriesStyle::line_and_points : command::SeriesStyle::points,
           .color = method.name == kLitfogName ? 0 : int(chart.series.size()) + 1});
    }
    const double error = std::max(errors->max_255, chart.y.least);  // 0 is drawn at the axis's end
    command::Series& series = chart.series.back();
    series.points.push_back({timing.median, error, method.nodes ? std::to_string(*method.nodes) : "",
                             chart.series.size() == 1 ? command::LabelPlace::above : command::LabelPlace::below});
  }
  return chart;
}

command::Table make_table(const std::vector<Measurement>& measurements) {
  command::Table table{
      {"method", "nodes", "fog", "lights", "lamp_leg", "ns_per_ray", "ns_spread", "max_error_255", "p99_relative"}};
  using Cell = command::Table::Cell;
  for (const auto& [method, timing, errors] : measurements) {
    const Problem& problem = *method.problem;
    table.rows.push_back({method.name, method.nodes ? Cell(double(*method.nodes)) : std::monostate(),
                          name_of(problem.fog), name_of(problem.mix), problem.lamp_leg == LampLeg::fogged ? 1.0 : 0.0,
                          timing.median, timing.spread, errors ? Cell(errors->max_255) : std::monostate(),
                          errors ? Cell(errors->p99_relative) : std::monostate()});
  }
  return table;
}

}  // namespace

Result measure_airlight(bool quick) {
  const Scale& scale = quick ? kQuick : kFull;
  command::Progress progress;
  std::list<Problem> problems;  // methods point at them
  for (const AirlightMix mix : {AirlightMix::point, AirlightMix::ahead, AirlightMix::droplets, AirlightMix::layers,
                                AirlightMix::any, AirlightMix::inverse_square}) {
    for (const FogMode fog : {FogMode::exp, FogMode::exp2}) {
      const bool is_exp_alone = mix != AirlightMix::point && mix != AirlightMix::any;
      if (is_exp_alone && fog == FogMode::exp2)
        continue;  // no rival supports it, or exp2 fog has no such phase functions and layers
      for (const LampLeg lamp_leg : {LampLeg::fogged, LampLeg::clear}) {
        progress.show(fmt::format("references of lights: {}, {} fog", name_of(mix), name_of(fog)));
        problems.emplace_back(mix, fog, lamp_leg, scale.rays);
      }
    }
  }
  const SunTable table;
  std::vector<Method> methods;
  for (Problem& problem : problems) {
    for (Method& method : methods_of(problem, table, scale.references)) methods.push_back(std::move(method));
  }
  std::vector<TimedPass> passes;
  for (const Method& method : methods) passes.push_back(method.pass);
  const auto timings = time_passes(passes, scale.stopwatch, progress);

  Result result;
  std::vector<Measurement> measurements;
  for (std::size_t i = 0; i < methods.size(); ++i) {
    const Method& method = methods[i];
    measurements.push_back({method, timings[i], std::nullopt});
    if (method.name == kReferenceName) continue;
    method.pass.run();  // restores this method's results, which the last one timed has overwritten
    const Errors errors = errors_of(*method.problem);
    measurements.back().errors = errors;
    const bool is_stated = method.name == kLitfogName && (method.problem->mix == AirlightMix::point ||
                                                          method.problem->mix == AirlightMix::inverse_square);
    if (is_stated && !(errors.max_255 <= 255 * kAirlightMaxError)) {
      result.failures.push_back(fmt::format("{} {} {}: error = {}/255: must be at most {}/255", method.name,
                                            name_of(method.problem->mix), name_of(method.problem->fog), errors.max_255,
                                            255 * kAirlightMaxError));
    }
  }
  result.table = make_table(measurements);
  result.figure = {.title = "Airlight of a lamp along a ray: time against error (exp fog, both legs)",
                   .charts = {draw_pareto("point lamps, isotropic fog", AirlightMix::point, 1e-3, measurements),
                              draw_pareto("all lamps, all fogs", AirlightMix::any, 1e-3, measurements),
                              draw_pareto("inverse-square point lamps, isotropic fog", AirlightMix::inverse_square,
                                          1e-16, measurements)},
                   .columns = 3,
                   .width = 1800,
                   .height = 600};
  return result;
}

}  // namespace litfog::bench
