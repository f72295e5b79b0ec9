// SPDX-License-Identifier: Apache-2.0
#include "fit/fit_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "files/angle_deg.h"

namespace litfog::fit {

namespace {

using litfog::ConeProfileFit;

constexpr int kSteps = 400;
constexpr double kMargin = 1.1;      // beyond the last target
constexpr double kDark = 0.002;      // fraction of the peak below which no angle is shown
constexpr double kLeastError = 0.5;  // percent: an axis of less would show rounding
constexpr int kTargetColor = 4;      // black
constexpr int kFirstColor = 0;
constexpr int kPlaneColor = 2;
constexpr int kLineColor = 7;  // of lines that no data make

/// A dashed line across a chart at a height.
command::Series level_line(double end, double level, const std::string& label = "") {
  return {.points = {{0, level}, {0.9 * end, level, label, command::LabelPlace::above}, {end, level}},
          .style = command::SeriesStyle::dashes,
          .color = kLineColor};
}

command::Axis error_axis(const char* label, const std::vector<command::Series>& errors) {
  double largest = 0;
  for (const command::Series& series : errors) {
    for (const command::PlotPoint& point : series.points) largest = std::max(largest, std::abs(point.y));
  }
  if (largest >= kLeastError) return {.label = label};
  return {.label = label, .least = -kLeastError, .most = kLeastError};
}

/// The beam in two planes of a luminaire, where they differ: a cone is fitted to the mean over the turn.
std::vector<command::Series> plane_series(const LightTarget& target, double end) {
  std::vector<command::Series> planes;
  if (!target.luminaire || target.asymmetry <= kRoundBeam) return planes;
  int color = kPlaneColor;
  for (const auto& [name, turn] : {std::pair{"horizontal", 0.0}, {"vertical", std::numbers::pi / 2}}) {
    command::Series& series =
        planes.emplace_back(command::Series{.name = name, .style = command::SeriesStyle::dashes, .color = color++});
    for (const AxialSample& sample : plane_profile(target.luminaire->distribution, turn, target.axis)) {
      if (files::degrees(sample.angle) <= end) series.points.push_back({files::degrees(sample.angle), sample.mean});
    }
  }
  return planes;
}

std::vector<command::Chart> range_charts(const LightFit& fit) {
  const auto& target = *fit.target.range;
  const auto& attenuation = fit.range->attenuation;
  command::Series targets{.name = "target", .style = command::SeriesStyle::points, .color = kTargetColor};
  command::Series errors{.style = command::SeriesStyle::points, .color = kFirstColor};
  const auto add = [&](double range, double wanted) {
    targets.points.push_back({range, wanted});
    errors.points.push_back({range, 100 * (attenuation_at(attenuation, range) / wanted - 1)});
  };
  for (const auto& sample : target.samples) add(sample.range, sample.attenuation);
  if (target.extent) add(*target.extent, target.threshold);
  double end = 0;
  for (const command::PlotPoint& point : targets.points) end = std::max(end, point.x);
  end *= kMargin;
  command::Series line{.name = "fit", .color = kFirstColor};
  for (int i = 0; i <= kSteps; ++i) {
    const double range = end * i / kSteps;
    line.points.push_back({range, attenuation_at(attenuation, range)});
  }
  const command::Axis range{.label = "range (m)", .most = end};
  const command::Axis fraction{.label = "attenuation", .most = 1.05};
  const command::Chart values{.x = range,
                              .y = fraction,
                              .series = {level_line(end, target.threshold, "threshold"), line, targets},
                              .key = command::KeyPlace::above};
  const command::Chart below{.x = range,
                             .y = error_axis("error (%)", {errors}),
                             .series = {level_line(end, 0), errors},
                             .key = command::KeyPlace::none};
  return {values, below};
}

std::vector<command::Chart> angle_charts(const LightFit& fit) {
  const auto& target = *fit.target.cone;
  double peak = 0;
  for (const auto& sample : target.samples) peak = std::max(peak, sample.weight > 0 ? sample.intensity : 0);
  const double unit = fit.target.luminaire ? peak : 1;  // candela where they are known
  command::Series targets{.name = "target", .style = command::SeriesStyle::points, .color = kTargetColor};
  if (target.beam_angle) targets.points.push_back({files::degrees(*target.beam_angle / 2), 0.5 * unit});
  if (target.field_angle) targets.points.push_back({files::degrees(*target.field_angle / 2), 0.1 * unit});
  for (const auto& sample : target.samples) {
    targets.points.push_back({files::degrees(sample.angle), sample.intensity / peak * unit});
  }
  std::vector<const ConeProfileFit*> profiles;
  for (const auto* profile : {&fit.cone->cosine, &fit.cone->smoothstep}) {
    if (*profile) profiles.push_back(&**profile);
  }
  double end = 0;  // of what is lit
  for (const auto* profile : profiles) end = std::max(end, files::degrees(angle_at_level(profile->cone, kDark)));
  for (const command::PlotPoint& point : targets.points) {
    if (point.y > kDark * unit) end = std::max(end, point.x);
  }
  end = std::min(180.0, end * kMargin);
  std::erase_if(targets.points, [end](const command::PlotPoint& point) { return point.x > end; });

  std::vector<command::Series> lines{level_line(end, 0.5 * unit, "50 %"), level_line(end, 0.1 * unit, "10 %")};
  for (command::Series& plane : plane_series(fit.target, end)) lines.push_back(std::move(plane));
  std::vector<command::Series> errors;
  int color = kFirstColor;
  for (const auto* profile : profiles) {
    const auto value = [&](double angle) { return unit * cone_at(profile->cone, std::cos(files::radians(angle))); };
    command::Series line{.name = name_of(profile->cone.profile), .color = color};
    for (int i = 0; i <= kSteps; ++i) line.points.push_back({end * i / kSteps, value(end * i / kSteps)});
    lines.push_back(std::move(line));
    command::Series error{.style = command::SeriesStyle::line_and_points, .color = color++};
    for (const command::PlotPoint& point : targets.points) {
      error.points.push_back({point.x, 100 * (value(point.x) - point.y) / unit});
    }
    errors.push_back(std::move(error));
  }
  lines.push_back(std::move(targets));
  double highest = unit;
  for (const command::Series& line : lines) {
    for (const command::PlotPoint& point : line.points) highest = std::max(highest, point.y);
  }
  const command::Axis angle{.label = "angle from the axis (deg)", .most = end};
  const command::Axis intensity{.label = fit.target.luminaire ? "intensity (cd)" : "intensity / peak",
                                .most = 1.05 * highest};
  const command::Axis error = error_axis("error (% of the peak)", errors);
  errors.insert(errors.begin(), level_line(end, 0));
  const command::Chart values{.x = angle, .y = intensity, .series = lines, .key = command::KeyPlace::above};
  const command::Chart below{.x = angle, .y = error, .series = errors, .key = command::KeyPlace::none};
  return {values, below};
}

}  // namespace

command::Figure fit_figure(const LightFit& fit) {
  std::vector<std::vector<command::Chart>> columns;
  if (fit.range) columns.push_back(range_charts(fit));
  if (fit.cone) columns.push_back(angle_charts(fit));
  command::Figure figure{.title = fit.light.name, .columns = int(columns.size())};
  figure.width = 600 * figure.columns;
  figure.height = 700;
  for (const std::size_t row : {0u, 1u}) {
    for (const auto& column : columns) figure.charts.push_back(column[row]);
  }
  return figure;
}

}  // namespace litfog::fit
