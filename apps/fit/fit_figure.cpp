// SPDX-License-Identifier: Apache-2.0
#include "fit/fit_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "files/angle_deg.h"

namespace litfog::fit {

namespace {

using litfog::ConeProfileFit;

constexpr int kSteps = 400;
constexpr double kMargin = 1.1;  // beyond the last target
constexpr int kTargetColor = 4;  // black
constexpr int kFirstColor = 0;

/// A line of zeros, so that a chart of errors shows it.
command::Series zero_line(double end) {
  return {.points = {{0, 0}, {end, 0}}, .style = command::SeriesStyle::dashes, .color = 7};
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
  const command::Axis error{.label = "error (%)"};
  const command::Chart values{.title = "Range", .x = range, .y = fraction, .series = {line, targets}};
  const command::Chart below{
      .x = range, .y = error, .series = {zero_line(end), errors}, .key = command::KeyPlace::none};
  return {values, below};
}

std::vector<command::Chart> angle_charts(const LightFit& fit) {
  const auto& target = *fit.target.cone;
  command::Series targets{.name = "target", .style = command::SeriesStyle::points, .color = kTargetColor};
  if (target.beam_angle) targets.points.push_back({files::degrees(*target.beam_angle / 2), 0.5});
  if (target.field_angle) targets.points.push_back({files::degrees(*target.field_angle / 2), 0.1});
  double peak = 0;
  for (const auto& sample : target.samples) peak = std::max(peak, sample.weight > 0 ? sample.intensity : 0);
  double end = 0;  // of what is lit
  for (const auto& sample : target.samples) {
    targets.points.push_back({files::degrees(sample.angle), sample.intensity / peak});
    if (sample.intensity > 0.002 * peak) end = std::max(end, files::degrees(sample.angle));
  }
  std::vector<command::Series> lines;
  std::vector<command::Series> errors;
  int color = kFirstColor;
  for (const auto* profile : {&fit.cone->cosine, &fit.cone->smoothstep}) {
    if (*profile) end = std::max(end, files::degrees(angle_at_level((*profile)->cone, 0.002)));
  }
  for (const command::PlotPoint& point : targets.points) {
    if (point.y > 0.002) end = std::max(end, point.x);
  }
  end = std::min(180.0, end * kMargin);
  std::erase_if(targets.points, [end](const command::PlotPoint& point) { return point.x > end; });
  for (const auto* profile : {&fit.cone->cosine, &fit.cone->smoothstep}) {
    if (!*profile) continue;
    const auto fraction = [cone = (*profile)->cone](double angle) {
      return cone_at(cone, std::cos(files::radians(angle)));
    };
    lines.push_back({.name = name_of((*profile)->cone.profile), .color = color});
    for (int i = 0; i <= kSteps; ++i) lines.back().points.push_back({end * i / kSteps, fraction(end * i / kSteps)});
    errors.push_back({.style = command::SeriesStyle::line_and_points, .color = color++});
    for (const command::PlotPoint& point : targets.points)
      errors.back().points.push_back({point.x, 100 * (fraction(point.x) - point.y)});
  }
  lines.push_back(targets);
  errors.insert(errors.begin(), zero_line(end));
  const command::Axis angle{.label = "angle from the axis (deg)", .most = end};
  const command::Axis fraction{.label = "intensity / peak", .most = 1.05};
  const command::Axis error{.label = "error (% of the peak)"};
  const command::Chart values{.title = "Cone", .x = angle, .y = fraction, .series = lines};
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
