// SPDX-License-Identifier: Apache-2.0
#include "bench/benchmarks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "bench/glow_rival.h"
#include "bench/stopwatch.h"
#include "command/progress.h"
#include "litfog/airlight.h"
#include "litfog/multiple_scattering.h"
#include "measure/inverse_square_lamp.h"
#include "measure/radial_scattering.h"
#include "measure/scattering_walk.h"

namespace litfog::bench {
namespace {

constexpr double kNearestAngle = 0.3, kFarthestAngle = 180;  // degrees
constexpr int kLinesAWalk = 4;                               // line segments of a chart between two walks
constexpr int kMarchSteps = 16;

/// A method for the glow over the angle in radians.
struct Method {
  std::string name;
  command::Series series;  ///< its look
  std::function<double(double)> glow;
};

/// A lamp in a fog.
struct Lamp {
  std::string kind;
  double parameter;
  double depth;
  Atmosphere air = {.fog = {FogMode::exp, 1}};
  PlacedLight light;
  std::vector<Method> methods = {};  ///< the reference is the first

  Lamp(const std::string& phase, double phase_parameter, double tau, const measure::RadialScattering::Glow& reference)
      : kind(phase), parameter(phase_parameter), depth(tau), light(lamp_ahead(tau)) {
    air.phase = kind == "hg" ? Phase::henyey_greenstein(parameter) : Phase::droplets(parameter);
    add_methods(reference);
  }

 private:
  void add_methods(const measure::RadialScattering::Glow& reference) {
    const auto add = [&](const char* name, const char* title, command::SeriesStyle style, int color, auto glow) {
      methods.push_back({name, {.name = title, .style = style, .color = color}, std::move(glow)});
    };
    using enum command::SeriesStyle;
    const ScatteringSource source = scattering_source(light.light, air);
    const double tau = depth, mean_cosine = litfog::mean_cosine(air.phase);
    const auto once = [lamp = light, fog = air](double angle) {
      return kQuadratic * airlight(lamp, fog, ray_beside(angle));
    };
    add("reference", "", line, 7, [lamp = light, fog = air, tau, reference](double angle) {
      return kQuadratic * reference_airlight(lamp, fog, ray_beside(angle)) + reference.at(tau, angle);
    });
    add("single", "scattered once", dashes, 0, once);
    add("all", "all orders", line, 1,
        [once, lamp = light, fog = air, source, table = make_scattering_table(air)](double angle) {
          return once(angle) + kQuadratic * multiple_scattering(lamp, source, fog, table, ray_beside(angle));
        });
    if (tau > 1) {
      add("apsf-2003", "APSF of 2003", line, 2, [=](double angle) { return apsf_glow(mean_cosine, tau, angle); });
    }
    add("gaussian-2004", "a Gaussian", line, 3, [=](double angle) { return gaussian_glow(mean_cosine, tau, angle); });
    add("octaves-2013", "octaves, 16 steps", line, 4,
        [phase = air.phase, tau](double angle) { return octave_glow(phase, tau, angle, kMarchSteps); });
  }
};

double degrees_at(double fraction) { return kNearestAngle * std::pow(kFarthestAngle / kNearestAngle, fraction); }
double radians(double degrees) { return degrees * std::numbers::pi / 180; }

}  // namespace

Result draw_glow(bool quick) {
  const int walks = quick ? 3 : 9;
  const auto walk_angle = [&](int i) { return degrees_at(double(i) / (walks - 1)); };
  command::Progress progress;
  progress.show("placing the nodes of the reference");
  const measure::RadialScattering solver(quick ? 0.6 : 1);
  std::vector<Lamp> lamps;
  for (const auto& [kind, parameter] : {std::pair<std::string, double>{"hg", 0}, {"droplets", 10}}) {
    progress.show(fmt::format("reference in {} {}", kind, parameter));
    const auto reference =
        solver.solve(kind == "hg" ? Phase::henyey_greenstein(parameter) : Phase::droplets(parameter));
    for (const double depth : {0.3, 1.0, 3.0, 6.0}) lamps.emplace_back(kind, parameter, depth, reference);
  }
  std::vector<TimedPass> passes;
  std::vector<double> results(std::size_t(walks), 0.0);
  for (const Lamp& lamp : lamps) {
    for (const Method& method : lamp.methods) {
      passes.push_back({results.size(), [&] {
                          for (int i = 0; i < walks; ++i) {
                            results[std::size_t(i)] = method.glow(radians(walk_angle(i)));
                          }
                        }});
    }
  }
  const std::vector<Timing> timings = time_passes(passes, {quick ? 1 : 9, quick ? 1e-4 : 0.01}, progress);

  Result result;
  result.table.columns = {"phase",      "parameter",      "tau",       "angle_deg", "method", "glow",
                          "glow_error", "relative_error", "ns_per_ray"};
  result.figure = {.title = "Glow around a point lamp in endless fog, tau mean free paths from the eye",
                   .columns = 4,
                   .width = 1900,
                   .height = 1000};
  std::size_t pass = 0;
  for (const Lamp& lamp : lamps) {
    const std::string name = fmt::format("{} {}, tau {}", lamp.kind, lamp.parameter, lamp.depth);
    command::Chart chart{
        .title = fmt::format("{}, tau = {}", lamp.kind == "hg" ? "isotropic" : "droplets of 10 um", lamp.depth),
        .x = {"angle from the lamp (degrees)", true, kNearestAngle, kFarthestAngle},
        .y = {"radiance / (I d^2)", true},
        .key = result.figure.charts.size() == 6 ? command::KeyPlace::bottom_left : command::KeyPlace::none};
    const auto add_row = [&](double degrees, const std::string& method, double glow, command::Table::Cell error,
                             command::Table::Cell time) {
      const double reference = lamp.methods.front().glow(radians(degrees));
      result.table.rows.push_back({lamp.kind, lamp.parameter, lamp.depth, degrees, method, glow, std::move(error),
                                   std::abs(glow / reference - 1), std::move(time)});
    };
    for (const Method& method : lamp.methods) {
      const double time = timings[pass++].median;
      for (int i = 0; i < walks; ++i) {
        add_row(walk_angle(i), method.name, method.glow(radians(walk_angle(i))), std::monostate(), time);
      }
      if (method.name == "reference") continue;  // the line of all orders would hide it
      command::Series series = method.series;
      for (int i = 0; i <= kLinesAWalk * (walks - 1); ++i) {
        const double degrees = degrees_at(double(i) / (kLinesAWalk * (walks - 1)));
        const double glow = method.glow(radians(degrees));
        if (method.name == "single") chart.y.least = i == 0 ? glow / 2 : std::min(chart.y.least, glow / 2);
        chart.y.most = std::max(chart.y.most, 2 * glow);
        if (glow > chart.y.least) series.points.push_back({degrees, glow});
      }
      chart.series.push_back(std::move(series));
    }
    command::Series walked{.name = "all orders, random walk", .style = command::SeriesStyle::points, .color = 7};
    std::vector<command::Series> bars;
    for (int i = 0; i < walks; ++i) {
      const double degrees = walk_angle(i);
      progress.show(fmt::format("walking in {}, at {:.2g} degrees", name, degrees));
      measure::ScatteringWalk walk;
      walk.paths = quick ? 256 : 65536;
      const measure::ScatteredLight light = walk_scattering(lamp.light, lamp.air, ray_beside(radians(degrees)), walk);
      const double value = kQuadratic * (light.first.value + light.higher.value);
      const double error = kQuadratic * std::hypot(light.first.error, light.higher.error);
      add_row(degrees, "walk", value, error, std::monostate());
      walked.points.push_back({degrees, value});
      if (error < value) {
        bars.push_back({.points = {{degrees, value - error}, {degrees, value + error}}, .color = 7});
      }
      const double all = lamp.methods[2].glow(radians(degrees));
      if (!quick && !(std::abs(all - value) <= 4 * error + kScatteringMaxError * value)) {
        result.failures.push_back(
            fmt::format("glow in {}, at {:.3g} degrees: {:.4g}, by the walk {:.4g}", name, degrees, all, value));
      }
    }
    chart.series.push_back(std::move(walked));
    chart.series.insert(chart.series.end(), bars.begin(), bars.end());
    result.figure.charts.push_back(std::move(chart));
  }
#ifdef LITFOG_HAS_GL
  result.strip = [quick] { return draw_glow_strip(quick); };
#endif
  return result;
}

}  // namespace litfog::bench
