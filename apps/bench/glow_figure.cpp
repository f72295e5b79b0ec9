// SPDX-License-Identifier: Apache-2.0
#include "bench/glow_figure.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "command/progress.h"
#include "litfog/airlight.h"
#include "litfog/multiple_scattering.h"
#include "measure/scattering_walk.h"

namespace litfog::bench {
namespace {

constexpr double kQuadratic = 1e12;                          // 1 / I; the knee is a millionth of a free path
constexpr double kNearestAngle = 0.3, kFarthestAngle = 180;  // degrees

Phase phase_of(const std::string& kind, double parameter) {
  return kind == "hg" ? Phase::henyey_greenstein(parameter) : Phase::droplets(parameter);
}

}  // namespace

Result draw_glow(bool quick) {
  const int steps_a_walk = 4, walks = quick ? 3 : 9;
  Result result;
  result.table.columns = {"phase", "parameter", "tau",        "angle_deg",     "single",
                          "all",   "walk",      "walk_error", "relative_error"};
  result.figure = {.title = "Glow around a point lamp in endless fog, tau mean free paths from the eye",
                   .columns = 4,
                   .width = 1500,
                   .height = 800};
  command::Progress progress;
  for (const auto& [kind, parameter] : {std::pair<std::string, double>{"hg", 0}, {"droplets", 10}}) {
    const Atmosphere air{.fog = {FogMode::exp, 1}, .phase = phase_of(kind, parameter)};
    const ScatteringTable table = make_scattering_table(air);
    for (const double depth : {0.3, 1.0, 3.0, 6.0}) {
      PlacedLight lamp;
      lamp.position.z = -depth;
      lamp.light.attenuation = {.constant = 0, .linear = 0, .quadratic = kQuadratic};
      lamp.light.threshold = 1e-17;
      command::Series single{.name = "scattered once", .style = command::SeriesStyle::dashes, .color = 0};
      command::Series all{.name = "all orders", .color = 1};
      command::Series walked{.name = "all orders, random walk", .style = command::SeriesStyle::points, .color = 7};
      std::vector<command::Series> bars;
      for (int i = 0; i <= steps_a_walk * (walks - 1); ++i) {
        const double degrees =
            kNearestAngle * std::pow(kFarthestAngle / kNearestAngle, double(i) / (steps_a_walk * (walks - 1)));
        const double angle = degrees * std::numbers::pi / 180;
        const EyeRay ray{.direction = {std::sin(angle), 0, -std::cos(angle)}};
        const double once = kQuadratic * airlight(lamp, air, ray);
        const double whole = once + kQuadratic * multiple_scattering(lamp, air, table, ray);
        single.points.push_back({degrees, once});
        all.points.push_back({degrees, whole});
        if (i % steps_a_walk != 0) continue;
        progress.show(fmt::format("walking in {} {}, tau {}, at {:.2g} degrees", kind, parameter, depth, degrees));
        measure::ScatteringWalk walk;
        walk.paths = quick ? 256 : 65536;
        const measure::ScatteredLight light = walk_scattering(lamp, air, ray, walk);
        const double value = kQuadratic * (light.first.value + light.higher.value);
        const double error = kQuadratic * std::hypot(light.first.error, light.higher.error);
        result.table.rows.push_back(
            {kind, parameter, depth, degrees, once, whole, value, error, std::abs(whole / value - 1)});
        walked.points.push_back({degrees, value});
        if (error < value) {
          bars.push_back({.points = {{degrees, value - error}, {degrees, value + error}}, .color = 7});
        }
        if (!quick && !(std::abs(whole - value) <= 4 * error + kScatteringMaxError * value)) {
          result.failures.push_back(fmt::format("glow in {} {}, tau {}, at {:.3g} degrees: {:.4g}, by the walk {:.4g}",
                                                kind, parameter, depth, degrees, whole, value));
        }
      }
      command::Chart chart{
          .title = fmt::format("{}, tau = {}", kind == "hg" ? "isotropic" : "droplets of 10 um", depth),
          .x = {"angle from the lamp (degrees)", true, kNearestAngle, kFarthestAngle},
          .y = {"radiance / (I d^2)", true},
          .series = {single, all, walked},
          .key = result.figure.charts.empty() ? command::KeyPlace::bottom_left : command::KeyPlace::none};
      chart.series.insert(chart.series.end(), bars.begin(), bars.end());
      result.figure.charts.push_back(std::move(chart));
    }
  }
  return result;
}

}  // namespace litfog::bench
