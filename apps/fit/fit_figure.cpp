// SPDX-License-Identifier: Apache-2.0
#include "fit/light_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <numbers>
#include <utility>

#include "files/angle_deg.h"
#include "text/code_points.h"

namespace litfog::fit {

namespace {

using command::PlotPoint;
using command::Series;
using command::SeriesStyle;
using std::numbers::pi;

constexpr int kSteps = 200;
constexpr double kMargin = 1.1;    // beyond the last target
constexpr double kDark = 0.002;    // fraction of the peak below which no angle is shown
constexpr double kMinError = 0.5;  // percent: an axis of less would show rounding
constexpr int kTargetColor = 4;    // black
constexpr int kFirstColor = 0;
constexpr int kPlaneColor = 2;
constexpr int kLineColor = 7;            // lines without data
constexpr std::size_t kMaxInKey = 40;    // letters of a light's name
constexpr std::size_t kMaxInTitle = 36;  // letters a column of charts, for all names

/// A name's first letters: a photometric file's may be a line of any length.
std::string shortened(std::string name, std::size_t most) {
  if (count_code_points(name) <= most) return name;
  std::size_t end = 0;
  for (std::size_t kept = 0; kept < most || !starts_code_point(name[end]); ++end) kept += starts_code_point(name[end]);
  return name.substr(0, end) + "…";
}

/// A light as it is drawn.
struct Subject {
  const LightFit& fit;
  int color;  ///< color of its first line
  int target_color;
  bool is_alone;

  std::string own_name = fit.light.name;

  /// A line's name in the key: of several lights, which colour tells apart, their own.
  std::string name(const std::string& line) const { return is_alone ? line : shortened(own_name, kMaxInKey); }
  /// The name of further lines in the light's colour.
  std::string second_name(const std::string& line) const { return is_alone ? line : ""; }
};

std::vector<Subject> subjects_of(const std::vector<const LightFit*>& fits) {
  std::vector<Subject> subjects;
  if (fits.size() == 1) return {{*fits.front(), kFirstColor, kTargetColor, true}};
  for (const LightFit* fit : fits) {
    const int color = int(subjects.size());
    subjects.push_back({*fit, color, color, false});
  }
  for (Subject& subject : subjects) {
    const auto count =
        std::ranges::count(fits, subject.fit.light.name, [](const LightFit* fit) { return fit->light.name; });
    if (count > 1) subject.own_name = std::filesystem::path(subject.fit.target.file).filename().string();
  }
  return subjects;
}

/// A dashed line across a chart at a height.
Series level_line(double end, double level, const std::string& label = "", double begin = 0) {
  return {.points = {{begin, level}, {0.9 * end, level, label, command::LabelPlace::above}, {end, level}},
          .style = SeriesStyle::dashes,
          .color = kLineColor};
}

/// With room around 0 and all errors, so that no mark is cut off.
command::Axis error_axis(const char* label, const std::vector<Series>& errors) {
  double least = 0, most = 0;
  for (const Series& series : errors) {
    for (const PlotPoint& point : series.points) {
      least = std::min(least, point.y);
      most = std::max(most, point.y);
    }
  }
  if (std::max(-least, most) < kMinError) return {.label = label, .least = -kMinError, .most = kMinError};
  const double room = 0.05 * (most - least);
  return {.label = label, .least = least - room, .most = most + room};
}

double highest_of(const std::vector<Series>& lines, double least) {
  for (const Series& line : lines) {
    for (const PlotPoint& point : line.points) least = std::max(least, point.y);
  }
  return least;
}

template <typename Value>
Series sampled(const std::string& name, int color, double begin, double end, const Value& value) {
  Series line{.name = name, .color = color};
  for (int i = 0; i <= kSteps; ++i) {
    const double x = begin + (end - begin) * i / kSteps;
    line.points.push_back({x, value(x)});
  }
  return line;
}

// --- over range ---

std::vector<PlotPoint> range_targets(const AttenuationTarget& target) {
  std::vector<PlotPoint> points;
  for (const auto& sample : target.samples) points.push_back({sample.range, sample.attenuation});
  if (target.extent) points.push_back({*target.extent, target.threshold});
  return points;
}

/// The axis of ranges, logarithmic for lights whose ends lie far apart: otherwise the nearer would be lost at 0.
command::Axis range_axis(const std::vector<Subject>& subjects) {
  constexpr double kFarApart = 30, kLeast = 0.01;  // multiples of the nearest end
  double nearest = std::numeric_limits<double>::infinity(), farthest = 0;
  for (const Subject& subject : subjects) {
    if (!subject.fit.range) continue;
    double end = 0;
    for (const PlotPoint& point : range_targets(*subject.fit.target.range)) end = std::max(end, kMargin * point.x);
    nearest = std::min(nearest, end);
    farthest = std::max(farthest, end);
  }
  const bool is_log = farthest > kFarApart * nearest;
  return {.label = "range (m)", .is_log = is_log, .least = is_log ? kLeast * nearest : 0, .most = farthest};
}

std::vector<command::Chart> range_charts(const std::vector<Subject>& subjects) {
  const command::Axis range = range_axis(subjects);
  const bool is_log = range.is_log;
  const double begin = range.least, end = range.most;
  std::vector<Series> lines, errors;
  for (const Subject& subject : subjects) {
    const LightFit& fit = subject.fit;
    if (!fit.range) continue;
    const Attenuation& attenuation = fit.range->attenuation;
    lines.push_back(level_line(end, fit.target.range->threshold, subject.is_alone ? "threshold" : "", begin));
    Series line =
        sampled(subject.name("fit"), subject.color, is_log ? std::log(begin) : begin, is_log ? std::log(end) : end,
                [&](double x) { return attenuation_at(attenuation, is_log ? std::exp(x) : x); });
    for (PlotPoint& point : line.points) point.x = is_log ? std::exp(point.x) : point.x;
    lines.push_back(std::move(line));
    lines.push_back({.name = subject.second_name("target"),
                     .points = range_targets(*fit.target.range),
                     .style = SeriesStyle::points,
                     .color = subject.target_color});
    std::erase_if(lines.back().points, [&](const PlotPoint& point) { return point.x < begin; });
    Series& error = errors.emplace_back(Series{.style = SeriesStyle::points, .color = subject.color});
    for (const auto& [x, y, label, place] : lines.back().points) {
      error.points.push_back({x, 100 * (attenuation_at(attenuation, x) / y - 1)});
    }
  }
  if (errors.empty()) return {};
  const command::Axis error = error_axis("error (%)", errors);
  errors.insert(errors.begin(), level_line(end, 0, "", begin));
  const command::Axis fraction{.label = "attenuation", .most = 1.05};
  const command::Chart values{.x = range, .y = fraction, .series = lines, .key = command::KeyPlace::above};
  const command::Chart below{.x = range, .y = error, .series = errors, .key = command::KeyPlace::none};
  return {values, below};
}

// --- over angle ---

/// The cone's data in degrees and, where all lights have an inverse square, candela.
struct ConeData {
  bool is_in_candela = false;
  double unit = 1;                      ///< the peak of the data, of data without candela the light's
  double light_unit = 1;                ///< the peak of the light as it is written
  std::vector<PlotPoint> targets = {};  ///< by increasing angle
  double end = 0;                       ///< degrees: of what is lit
};

bool has_candela(const std::vector<Subject>& subjects) {
  return std::ranges::all_of(
      subjects, [](const Subject& subject) { return !subject.fit.cone || subject.fit.peak.value_or(0) > 0; });
}

std::vector<const ConeProfileFit*> profiles_of(const Subject& subject) {
  const ConeFit& cone = *subject.fit.cone;
  if (!subject.is_alone) return {&cone.best()};
  std::vector<const ConeProfileFit*> profiles;
  for (const ConeProfileFit& profile : cone.profiles) profiles.push_back(&profile);
  return profiles;
}

ConeData cone_data(const Subject& subject, bool is_in_candela) {
  const ConeTarget& target = *subject.fit.target.cone;
  const double peak = peak_of(target.samples);
  ConeData data{.is_in_candela = is_in_candela};
  if (is_in_candela) {
    data.light_unit = *subject.fit.peak;
    data.unit = subject.fit.target.luminaire ? peak : subject.fit.target.peak.value_or(data.light_unit);
    if (subject.fit.cookie) data.light_unit = data.unit;  // the peak is its cookie's, and none of a cone
  }
  if (target.beam_angle) data.targets.push_back({files::degrees(*target.beam_angle / 2), 0.5 * data.unit});
  if (target.field_angle) data.targets.push_back({files::degrees(*target.field_angle / 2), 0.1 * data.unit});
  for (const auto& sample : target.samples) {
    data.targets.push_back({files::degrees(sample.angle), sample.intensity / peak * data.unit});
  }
  std::ranges::stable_sort(data.targets, {}, &PlotPoint::x);  // a stated angle may lie among the samples
  for (const auto* profile : profiles_of(subject)) {
    data.end = std::max(data.end, files::degrees(angle_at_level(profile->cone, kDark)));
  }
  for (const PlotPoint& point : data.targets) {
    if (point.y > kDark * data.unit) data.end = std::max(data.end, point.x);
  }
  data.end = std::min(180.0, kMargin * data.end);
  return data;
}

/// Marks of a few points, a line through many, whose marks would lie on each other.
SeriesStyle style_of(const std::vector<PlotPoint>& points, SeriesStyle marks) {
  constexpr std::size_t kMaxMarks = 100;
  return points.size() > kMaxMarks ? SeriesStyle::line : marks;
}

double value_of(const ConeProfileFit& profile, double unit, double angle_deg) {
  return unit * cone_at(profile.cone, std::cos(files::radians(angle_deg)));
}

/// The measured or elliptical beam behind a cone, in the unit of its data.
class Beam {
 public:
  /// subject  a light with a beam
  Beam(const Subject& subject, const ConeData& data)
      : distribution_(*subject.fit.beam()),
        axis_(subject.fit.target.axis),
        is_round_(subject.fit.target.asymmetry <= kRoundBeam),
        scale_(subject.fit.target.luminaire && data.is_in_candela ? 1
                                                                  : data.unit / find_peak(distribution_).intensity) {}

  bool is_round() const { return is_round_; }

  /// Angles in degrees and intensities along a half plane.
  std::vector<PlotPoint> half_plane(double turn) const {
    std::vector<PlotPoint> points;
    for (const AxialSample& sample : plane_profile(distribution_, turn, axis_)) {
      points.push_back({files::degrees(sample.angle), scale_ * sample.mean});
    }
    return points;
  }

  /// A plane from -180 to 180 degrees.
  std::vector<PlotPoint> plane(double turn) const {
    std::vector<PlotPoint> points = half_plane(turn + pi);
    for (PlotPoint& point : points) point.x = -point.x;
    std::ranges::reverse(points);
    for (PlotPoint& point : half_plane(turn)) points.push_back(std::move(point));
    return points;
  }

  /// The largest distance from the mean over the turn, in percent of the peak.
  std::vector<PlotPoint> spread(double end) const {
    const double peak = find_peak(distribution_).intensity;
    std::vector<PlotPoint> points;
    for (const AxialSample& sample : AxialBeam(distribution_, axis_).profile()) {
      if (files::degrees(sample.angle) > end) break;
      points.push_back({files::degrees(sample.angle), 100 * sample.deviation / peak});
    }
    return points;
  }

 private:
  const IntensityDistribution& distribution_;
  glm::dvec3 axis_;
  bool is_round_;
  double scale_;
};

struct NamedTurn {
  const char* name;
  double turn;
};
/// Two planes through the axis. A lamp that hangs has names for those through its own; about another none is level.
std::array<NamedTurn, 2> planes_of(const LightFit& fit) {
  if (!fit.target.luminaire || !hangs(*fit.target.luminaire)) return {{{"horizontal", 0}, {"vertical", pi / 2}}};
  const bool is_own_axis = fit.target.axis == kPhotometricAxis || fit.target.axis == -kPhotometricAxis;
  if (is_own_axis) return {{{"C0-C180", 0}, {"C90-C270", pi / 2}}};
  return {{{"turn 0-180°", 0}, {"turn 90-270°", pi / 2}}};
}

std::vector<Series> plane_series(const Subject& subject, const ConeData& data, double end) {
  std::vector<Series> planes;
  if (!subject.fit.beam()) return planes;
  const Beam beam(subject, data);
  if (beam.is_round()) return planes;
  int color = kPlaneColor;
  for (const auto& [name, turn] : planes_of(subject.fit)) {
    Series& series = planes.emplace_back(Series{.name = name, .style = SeriesStyle::dashes, .color = color++});
    series.points = beam.half_plane(turn);
    std::erase_if(series.points, [end](const PlotPoint& point) { return point.x > end; });
  }
  return planes;
}

std::vector<command::Chart> angle_charts(const std::vector<Subject>& subjects) {
  const bool is_in_candela = has_candela(subjects);
  double end = 0, unit = 0;
  for (const Subject& subject : subjects) {
    if (!subject.fit.cone) continue;
    const ConeData data = cone_data(subject, is_in_candela);
    end = std::max(end, data.end);
    unit = std::max({unit, data.unit, data.light_unit});
  }
  if (end == 0) return {};
  std::vector<Series> lines, errors;
  if (subjects.front().is_alone) lines = {level_line(end, 0.5 * unit, "50 %"), level_line(end, 0.1 * unit, "10 %")};
  for (const Subject& subject : subjects) {
    if (!subject.fit.cone) continue;
    ConeData data = cone_data(subject, is_in_candela);
    std::erase_if(data.targets, [end](const PlotPoint& point) { return point.x > end; });
    if (subject.is_alone) {
      for (Series& plane : plane_series(subject, data, end)) lines.push_back(std::move(plane));
    }
    int color = subject.color;
    for (const auto* profile : profiles_of(subject)) {
      lines.push_back(sampled(subject.name(facts_of(profile->cone.profile).name), color, 0, end,
                              [&](double angle) { return value_of(*profile, data.light_unit, angle); }));
      Series& error =
          errors.emplace_back(Series{.style = style_of(data.targets, SeriesStyle::line_and_points), .color = color++});
      for (const PlotPoint& point : data.targets) {
        error.points.push_back({point.x, 100 * (value_of(*profile, 1, point.x) - point.y / data.unit)});
      }
    }
    SeriesStyle style = style_of(data.targets, SeriesStyle::points);
    if (!subject.is_alone && style == SeriesStyle::line) style = SeriesStyle::dashes;  // the cone has that colour, too
    lines.push_back({.name = subject.second_name("target"),
                     .points = std::move(data.targets),
                     .style = style,
                     .color = subject.target_color});
  }
  const command::Axis angle{.label = "angle from the axis (deg)", .most = end};
  const command::Axis intensity{.label = is_in_candela ? "intensity (cd)" : "intensity / peak",
                                .most = 1.05 * highest_of(lines, unit)};
  const command::Axis error = error_axis("error (% of the peak)", errors);
  errors.insert(errors.begin(), level_line(end, 0));
  const command::Chart values{.x = angle, .y = intensity, .series = lines, .key = command::KeyPlace::above};
  const command::Chart below{.x = angle, .y = error, .series = errors, .key = command::KeyPlace::none};
  return {values, below};
}

// --- over the turn ---

command::Chart polar_chart(const std::vector<Subject>& subjects) {
  const bool is_in_candela = has_candela(subjects);
  std::vector<Series> lines;
  double unit = 0;
  for (const Subject& subject : subjects) {
    if (!subject.fit.cone) continue;
    const ConeData data = cone_data(subject, is_in_candela);
    unit = std::max({unit, data.unit, data.light_unit});
    const ConeProfileFit& best = subject.fit.cone->best();
    lines.push_back(sampled(subject.name(facts_of(best.cone.profile).name),
                            subject.color + (subject.is_alone && &best != profiles_of(subject).front() ? 1 : 0),
                            -data.end, data.end, [&](double angle) { return value_of(best, data.light_unit, angle); }));
    if (!subject.fit.beam()) continue;
    const Beam beam(subject, data);
    if (beam.is_round()) {
      lines.push_back({.name = subject.second_name("target"),
                       .points = beam.plane(0),
                       .style = subject.is_alone ? SeriesStyle::line : SeriesStyle::dashes,
                       .color = subject.target_color});
      continue;
    }
    int color = kPlaneColor;
    for (const auto& [name, turn] : planes_of(subject.fit)) {
      lines.push_back({.name = subject.second_name(name),
                       .points = beam.plane(turn),
                       .style = SeriesStyle::dashes,
                       .color = subject.is_alone ? color++ : subject.color});
    }
  }
  return {.x = {},
          .y = {.label = is_in_candela ? "intensity (cd)" : "intensity / peak", .most = highest_of(lines, unit)},
          .series = lines,
          .key = subjects.front().is_alone ? command::KeyPlace::beside : command::KeyPlace::none,
          .is_polar = true};
}

command::Chart spread_chart(const std::vector<Subject>& subjects) {
  command::Chart chart{.x = {.label = "angle from the axis (deg)"},
                       .y = {.label = "spread over the turn (% of the peak)"},
                       .key = subjects.front().is_alone ? command::KeyPlace::none : command::KeyPlace::above};
  for (const Subject& subject : subjects) {
    if (!subject.fit.cone || !subject.fit.beam()) continue;
    const ConeData data = cone_data(subject, has_candela(subjects));
    chart.x.most = std::max(chart.x.most, data.end);
    chart.series.push_back(
        {.name = subject.name(""), .points = Beam(subject, data).spread(data.end), .color = subject.color});
  }
  chart.y.most = 1.05 * highest_of(chart.series, kMinError);
  return chart;
}

}  // namespace

command::Figure fit_figure(const std::vector<const LightFit*>& fits) {
  const std::vector<Subject> subjects = subjects_of(fits);
  std::vector<std::vector<command::Chart>> columns;
  if (auto charts = range_charts(subjects); !charts.empty()) columns.push_back(std::move(charts));
  if (auto charts = angle_charts(subjects); !charts.empty()) {
    columns.push_back(std::move(charts));
    columns.push_back({polar_chart(subjects), spread_chart(subjects)});
  }
  command::Figure figure{.columns = int(columns.size())};
  const std::size_t most = kMaxInTitle * columns.size() / fits.size();
  for (const Subject& subject : subjects) {
    figure.title += (figure.title.empty() ? "" : " / ") + shortened(subject.own_name, most);
  }
  figure.width = 600 * figure.columns;
  figure.height = 780;
  for (const std::size_t row : {0u, 1u}) {
    for (const auto& column : columns) figure.charts.push_back(column[row]);
  }
  return figure;
}

}  // namespace litfog::fit
