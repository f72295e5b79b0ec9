// SPDX-License-Identifier: Apache-2.0
#include "bench/benchmarks.h"

#include <ceres/ceres.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "bench/stopwatch.h"
#include "command/progress.h"
#include "litfog/fit/attenuation_fit.h"
#include "litfog/formulas.h"
#include "reference/falloff_reference.h"
#include "reference/random_light.h"

namespace litfog::bench {
namespace {

using Samples = std::vector<AttenuationSample>;

struct Scale {
  int tables;
  StopwatchSettings stopwatch;
};
constexpr Scale kFull{100, {15, 0.05}};
constexpr Scale kQuick{8, {3, 0.001}};

/// Digits of the optimum that the header states (attenuation_fit.h).
constexpr double kStatedDigits = 9;

/// A distribution of tables.
struct Family {
  const char* name;
  double least_range, most_range;  ///< limits of the last sample's range
  double noise;                    ///< standard deviation of ln attenuation
  double outliers;                 ///< fraction of the samples
  bool is_clamped;
};
constexpr Family kFamilies[] = {
    {"exact", 1, 1000, 0, 0, false},      {"noise-2", 1, 1000, 0.02, 0, false},
    {"noise-20", 1, 1000, 0.2, 0, false}, {"outliers", 1, 1000, 0.02, 0.125, false},
    {"clamped", 1, 1000, 0.02, 0, true},  {"far", 1e4, 1e6, 0.02, 0, false},
    {"near", 1e-3, 0.1, 0.02, 0, false},
};

Samples draw_table(const Family& family, test::Random& random) {
  const double last = random.log_uniform(family.least_range, family.most_range);
  const Attenuation light{family.is_clamped ? random.uniform(0.1, 0.9) : random.uniform(1, 3),
                          random.log_uniform(0.5, 10) / last, random.log_uniform(1, 40) / last / last};
  Samples samples;
  for (int i = 1; i <= 20; ++i) {
    const double range = last * i / 20;
    double log_error = 0;
    for (int k = 0; k < 12; ++k) log_error += family.noise * random.uniform(-0.5, 0.5);  // each with variance 1/12
    if (random.chance(family.outliers)) log_error += random.pick(std::array{-1, 1}) * random.uniform(0.7, 3);
    samples.push_back({range, std::min(1.0, attenuation_at(light, range) * std::exp(log_error))});
  }
  return samples;
}

Attenuation fit_by_litfog(const Samples& samples) { return fit_attenuation({.samples = samples}).attenuation; }

/// ln a(r) minus a sample's ln a, from coefficients of any scalar type.
struct Residual {
  const AttenuationSample& sample;

  template <typename T>
  bool operator()(const T* coefficients, T* residual) const {
    using std::log;
    residual[0] = log(formulas::attenuation(T(sample.range), coefficients[0], coefficients[1], coefficients[2])) -
                  std::log(sample.attenuation);
    return true;
  }
};

Attenuation fit_by_ceres(const Samples& samples) {
  std::array<double, 3> coefficients{1, 1, 1};
  ceres::Problem problem;
  for (const AttenuationSample& sample : samples) {
    problem.AddResidualBlock(new ceres::AutoDiffCostFunction<Residual, 1, 3>(new Residual{sample}), nullptr,
                             coefficients.data());
  }
  for (int j = 0; j < 3; ++j) problem.SetParameterLowerBound(coefficients.data(), j, 0);
  ceres::Solver::Options options;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  return {coefficients[0], coefficients[1], coefficients[2]};
}

struct Method {
  const char* name;
  Attenuation (*fit)(const Samples&);
  double stated_digits;
};
constexpr Method kMethods[] = {{"litfog", fit_by_litfog, kStatedDigits}, {"ceres", fit_by_ceres, 0}};

double objective(const Attenuation& a, const Samples& samples) {
  double sum = 0;
  for (const AttenuationSample& sample : samples) {
    const double residual = std::log(attenuation_at(a, sample.range) / sample.attenuation);
    sum += residual * residual;
  }
  return sum;
}

struct Optimum {
  std::vector<test::Digits50> log_attenuation;  ///< one per sample
  double objective = std::numeric_limits<double>::infinity();
};

/// The certified optimum of a table, from the best fit found.
Optimum certified_optimum(const Samples& samples, const std::vector<Attenuation>& found) {
  const auto& best = *std::min_element(found.begin(), found.end(), [&](const Attenuation& a, const Attenuation& b) {
    return objective(a, samples) < objective(b, samples);
  });
  const test::FalloffReferenceSearch search({.samples = samples}, std::numeric_limits<double>::infinity());
  const test::FalloffReference reference = search.certify({best.constant, best.linear, best.quadratic});
  if (!reference.is_certified) return {};
  Optimum optimum;
  optimum.objective = double(reference.objective);
  const auto& [constant, linear, quadratic] = reference.coefficients;
  for (const AttenuationSample& sample : samples) {
    const test::Digits50 r = sample.range;
    const test::Digits50 denominator = constant + r * (linear + r * quadratic);
    optimum.log_attenuation.push_back(denominator > 1 ? test::Digits50(-log(denominator)) : test::Digits50(0));
  }
  return optimum;
}

double digits_of(const Attenuation& a, const Samples& samples, const Optimum& optimum) {
  double worst = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double error = std::abs(double(std::log(attenuation_at(a, samples[i].range)) - optimum.log_attenuation[i]));
    worst = std::isnan(error) ? 1 : std::max(worst, error);
  }
  return std::clamp(-std::log10(worst), 0.0, 17.0);
}

/// A method on the tables of a family.
struct Run {
  const Family* family;
  const Method* method;
  const std::vector<Samples>* tables;
  std::vector<Attenuation> found;  ///< one per table
};

/// The measurements of a run.
struct Measurement {
  const Family* family;
  const Method* method;
  std::size_t tables;
  Timing timing;           ///< ns per table
  double objective;        ///< mean over the tables
  double solved_fraction;  ///< fraction of the tables
  double digits;           ///< the fewest of all tables
};

/// Draws tables for each family.
std::vector<std::vector<Samples>> draw_tables(int count) {
  test::Random random(20'040'601);
  std::vector<std::vector<Samples>> tables;
  for (const Family& family : kFamilies) {
    auto& drawn = tables.emplace_back();
    for (int i = 0; i < count; ++i) drawn.push_back(draw_table(family, random));
  }
  return tables;
}

/// All methods on the first family, then on the next.
///
/// tables  must outlive the runs
std::vector<Run> runs_on(const std::vector<std::vector<Samples>>& tables) {
  std::vector<Run> runs;
  for (std::size_t i = 0; i < tables.size(); ++i) {
    for (const Method& method : kMethods) {
      runs.push_back({&kFamilies[i], &method, &tables[i], std::vector<Attenuation>(tables[i].size())});
    }
  }
  return runs;
}

std::vector<Timing> time_runs(std::vector<Run>& runs, const StopwatchSettings& settings) {
  std::vector<TimedPass> passes;
  for (Run& run : runs) {
    passes.push_back({run.tables->size(), [&run] {
                        for (std::size_t i = 0; i < run.found.size(); ++i) {
                          run.found[i] = run.method->fit((*run.tables)[i]);
                        }
                      }});
  }
  command::Progress progress;
  return time_passes(passes, settings, progress);
}

/// The optimum of each table; none if no method found it.
///
/// runs  of all methods on one family
std::vector<Optimum> optima_of(std::span<const Run> runs) {
  std::vector<Optimum> optima;
  for (std::size_t i = 0; i < runs.front().tables->size(); ++i) {
    std::vector<Attenuation> found;
    for (const Run& run : runs) found.push_back(run.found[i]);
    optima.push_back(certified_optimum((*runs.front().tables)[i], found));
  }
  return optima;
}

Measurement assess(const Run& run, const Timing& timing, const std::vector<Optimum>& optima) {
  double sum = 0, digits = 17;
  int solved = 0;
  for (std::size_t i = 0; i < optima.size(); ++i) {
    const Samples& samples = (*run.tables)[i];
    const double value = objective(run.found[i], samples);
    sum += value;
    if (optima[i].log_attenuation.empty()) continue;
    if (value <= optima[i].objective * 1.001 + 1e-20) ++solved;
    digits = std::min(digits, digits_of(run.found[i], samples, optima[i]));
  }
  const auto size = double(optima.size());
  return {run.family, run.method, optima.size(), timing, sum / size, solved / size, digits};
}

command::Table make_table(const std::vector<Measurement>& measurements) {
  command::Table table{{"problem", "method", "tables", "ms", "ms_spread", "objective", "solved_share", "digits"}};
  for (const Measurement& m : measurements) {
    table.rows.push_back({m.family->name, m.method->name, double(m.tables), m.timing.median / 1e6,
                          m.timing.spread / 1e6, m.objective, m.solved_fraction, m.digits});
  }
  return table;
}

}  // namespace

Result measure_fit(bool quick) {
  const Scale& scale = quick ? kQuick : kFull;
  const std::vector<std::vector<Samples>> tables = draw_tables(scale.tables);
  std::vector<Run> runs = runs_on(tables);
  const std::vector<Timing> timings = time_runs(runs, scale.stopwatch);

  Result result;
  std::vector<Measurement> measurements;
  constexpr std::size_t kMethodCount = std::size(kMethods);
  for (std::size_t first = 0; first < runs.size(); first += kMethodCount) {
    const std::vector<Optimum> optima = optima_of(std::span(runs).subspan(first, kMethodCount));
    for (std::size_t i = 0; i < optima.size(); ++i) {
      if (!optima[i].log_attenuation.empty()) continue;
      result.failures.push_back(fmt::format("{}, table {}: nothing found is an optimum", runs[first].family->name, i));
    }
    for (std::size_t i = first; i < first + kMethodCount; ++i) {
      const Method& method = *runs[i].method;
      const Measurement& measurement = measurements.emplace_back(assess(runs[i], timings[i], optima));
      if (measurement.digits >= method.stated_digits) continue;
      result.failures.push_back(fmt::format("{} {}: digits = {}: must be at least {}", method.name,
                                            measurement.family->name, measurement.digits, method.stated_digits));
    }
  }
  result.table = make_table(measurements);
  return result;
}

}  // namespace litfog::bench
