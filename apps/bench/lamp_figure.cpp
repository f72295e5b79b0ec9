// SPDX-License-Identifier: Apache-2.0
#include "bench/benchmarks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "command/bundled_data.h"
#include "litfog/airlight.h"
#include "litfog/files/light_file.h"
#include "litfog/solve.h"
#include "text/shown_number.h"

namespace litfog::bench {
namespace {

constexpr const char* kLamps[] = {"room-bulb", "hand-torch", "street-lamp", "landing-lamp"};
constexpr double kMinVisibility = 1;
constexpr double kMaxVisibility = 20'000;

}  // namespace

Result measure_lamps(bool quick) {
  const int steps = quick ? 8 : 96;
  const int steps_a_mark = steps / 8;
  Result result;
  result.table.columns = {"lamp",        "visibility_m", "peak",         "airlight_k0",
                          "airlight_k1", "reference_k0", "reference_k1", "max_error_255"};
  result.figure = {.title = "A lamp at the eye, seen along its axis: light that the fog scatters back",
                   .columns = 2,
                   .width = 1000,
                   .height = 720};
  for (const char* lamp : kLamps) {
    const Light light = read_light((command::bundled_folder("lights") / fmt::format("{}.json", lamp)).string());
    const PlacedLight placed{.light = light, .carried = true};
    const EyeRay ray{.direction = placed.direction};
    command::Series peak{.name = "peak (Hales)", .style = command::SeriesStyle::dashes, .color = 4};
    command::Series clear{.name = "airlight, k = 0", .color = 0};
    command::Series fogged{.name = "airlight, k = 1", .color = 1};
    command::Series references{.name = "reference", .style = command::SeriesStyle::points, .color = 7};
    for (int i = 0; i <= steps; ++i) {
      const double visibility = kMinVisibility * std::pow(kMaxVisibility / kMinVisibility, double(i) / steps);
      const Fog fog = Fog::from_visibility(FogMode::exp, visibility);
      const double intensity = solve_fog_intensity(light, fog).intensity;
      const double computed[] = {axial_airlight(light, fog), airlight(placed, {fog}, ray)};
      const double reference[] = {reference_airlight(placed, {fog}, ray, LampLeg::clear),
                                  reference_airlight(placed, {fog}, ray)};
      const double error = 255 * std::max(std::abs(computed[0] - reference[0]), std::abs(computed[1] - reference[1]));
      result.table.rows.push_back(
          {lamp, visibility, intensity, computed[0], computed[1], reference[0], reference[1], error});
      peak.points.push_back({visibility, intensity});
      clear.points.push_back({visibility, computed[0]});
      fogged.points.push_back({visibility, computed[1]});
      if (i % steps_a_mark != 0) continue;
      references.points.push_back({visibility, reference[0]});
      references.points.push_back({visibility, reference[1]});
    }
    result.figure.charts.push_back(
        {.title = fmt::format("{}, reaching {} m", lamp,
                              shown_rounded(compute_extent(light.attenuation, light.threshold), 3)),
         .x = {"visibility (m)", true, kMinVisibility, kMaxVisibility},
         .y = {"fraction of the lamp's colour", false, 0, 1},
         .series = {peak, clear, fogged, references},
         .key = result.figure.charts.empty() ? command::KeyPlace::top_right : command::KeyPlace::none});
  }
  return result;
}

}  // namespace litfog::bench
