// SPDX-License-Identifier: Apache-2.0
#include "fit/data_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <utility>

#include "command/printable.h"
#include "command/table.h"
#include "files/light_json.h"
#include "fit/light_fit.h"
#include "fit/verdict.h"
#include "text/shown_number.h"

namespace litfog::fit {

namespace {

constexpr std::size_t kMaxRows = 40;

using Row = std::vector<command::Table::Cell>;

class Sheet {
 public:
  void add_heading(const std::string& text) { text_ += fmt::format("\n{}\n", text); }
  /// value  may hold names as files have them
  void add(std::string_view name, const std::string& value) {
    text_ += fmt::format("  {:<16}{}\n", name, command::printable(value));
  }
  void add(const command::Table& table) {
    text_ += "\n";
    append(table);
  }
  /// A row for each sample, or for some evenly spread ones where there are too many to read.
  ///
  /// row_of  the row of sample i
  void add_samples(command::Table table, std::size_t count, const std::function<Row(std::size_t)>& row_of) {
    const std::size_t step = (count + kMaxRows - 1) / kMaxRows;
    text_ += step > 1 ? fmt::format("\n  One of every {} samples:\n", step) : "\n";
    for (std::size_t i = 0; i < count; i += step) table.rows.push_back(row_of(i));
    append(table);
  }
  const std::string& text() const { return text_; }

 private:
  void append(const command::Table& table) {
    const std::string text = command::format_table(table, command::TableFormat::text);
    for (std::size_t begin = 0; begin < text.size();) {
      const std::size_t end = text.find('\n', begin) + 1;
      text_ += "  " + text.substr(begin, end - begin);
      begin = end;
    }
  }

  std::string text_;
};

std::string joined(const std::vector<std::string>& words) {
  return words.empty() ? "none" : fmt::format("{}", fmt::join(words, ", "));
}

/// In percent, without the noise of rounding.
double percent_of(double fraction) { return std::abs(fraction) < 1e-11 ? 0 : 100 * fraction; }

void add_range(Sheet& sheet, const AttenuationTarget& target, const AttenuationFit& fit) {
  sheet.add_heading(fmt::format("Range: {}", name_of(fit.status)));
  const auto& [constant, linear, quadratic] = fit.attenuation;
  sheet.add("attenuation", fmt::format("1 / (C + L r + Q r^2), at most 1: C = {:.9g}, L = {:.9g} /m, Q = {:.9g} /m^2",
                                       constant, linear, quadratic));
  constexpr double kSame = 1e-12;  // relative error of an extent that is met
  const double end = compute_extent(fit.attenuation, fit.threshold), wanted = target.extent.value_or(end);
  sheet.add("extent", fmt::format("{} m, where the attenuation is {}",
                                  shown_number(std::abs(end - wanted) <= kSame * wanted ? wanted : end),
                                  shown_number(fit.threshold)) +
                          (target.extent ? fmt::format(" (wanted {} m)", shown_number(wanted)) : ""));
  const double clamped = compute_knee(fit.attenuation);
  if (clamped > 0) sheet.add("knee", fmt::format("{} m, full brightness up to there", shown_number(clamped)));
  if (!fit.sentence.empty()) sheet.add("outcome", fit.sentence);
  std::vector<std::string> active;
  for (const auto constraint : fit.active) active.emplace_back(litfog::name_of(constraint));
  sheet.add("held by", joined(active));
  if (!target.samples.empty()) {
    sheet.add("error", fmt::format("rms {} %, largest {} %, of the attenuation; objective {:.6g}",
                                   shown_rounded(percent_of(fit.rms_error), 3),
                                   shown_change(percent_of(fit.largest_error), 3), fit.objective));
    if (!fit.covariance) {
      sheet.add("uncertainty", "not identifiable");
    } else {
      const auto deviation = [&fit](std::size_t i) { return shown_rounded(std::sqrt((*fit.covariance)[4 * i]), 2); };
      sheet.add("uncertainty", fmt::format("C +-{}, L +-{}, Q +-{} (one standard deviation)", deviation(0),
                                           deviation(1), deviation(2)));
    }
  }
  sheet.add("certificate",
            fmt::format("KKT residual {:.1e}; boxes ruled out: {}; iterations: {}, {} ms", fit.kkt_residual, fit.boxes,
                        fit.iterations, shown_rounded(fit.milliseconds, 3)));
  if (target.samples.empty()) return;
  sheet.add_samples({.columns = {"range_m", "attenuation", "fitted", "error_%", "weight"}, .rows = {}},
                    target.samples.size(), [&](std::size_t i) {
                      const auto& [range, attenuation, weight] = target.samples[i];
                      return Row{range, attenuation, attenuation_at(fit.attenuation, range),
                                 percent_of(std::expm1(fit.residuals[i])), weight};
                    });
}

std::string percent(const std::optional<double>& error) {
  return error ? shown_change(percent_of(*error), 3) + " %" : "-";
}

std::string uncertainty_of(const ConeProfileFit& fit) {
  if (!fit.covariance) return "not identifiable";
  std::vector<std::string> texts;
  for (const ConeParameter& parameter : fitted_parameters(fit.cone.profile)) {
    const double deviation = std::sqrt((*fit.covariance)[texts.size()][texts.size()]);
    const double shown = parameter.is_angle ? deviation / files::radians(1) : deviation;
    texts.push_back(parameter.file_name + (shown > 0 ? " +-" + shown_rounded(shown, 2) : " held"));
  }
  return joined(texts);
}

std::string edge_of(const ConeProfileFit& fit) {
  const auto [least, most] = fit.cutoff_range;
  if (least == most) return "-";
  return fmt::format("in ({:.4g}, {:.4g}] deg", files::degrees(least), files::degrees(most));
}

void add_cone(Sheet& sheet, const ConeTarget& target, const ConeFit& fit) {
  sheet.add_heading(fmt::format("Cone: {} ({})", facts_of(fit.best().cone.profile).name, name_of(fit.best().status)));
  std::vector<std::string> wanted;
  const auto add_angle = [&wanted](const char* name, const std::optional<double>& angle) {
    if (angle) wanted.push_back(fmt::format("{} {} deg", name, files::shown_degrees(*angle)));
  };
  add_angle("beam angle", target.beam_angle);
  add_angle("field angle", target.field_angle);
  add_angle("half angle", target.half_angle);
  if (!target.samples.empty()) wanted.push_back(fmt::format("{} samples", target.samples.size()));
  sheet.add("wanted", joined(wanted));

  command::Table table{.columns = {"profile"}};
  for (const ConeProfileFit& profile : fit.profiles) table.columns.emplace_back(facts_of(profile.cone.profile).name);
  const auto add_row = [&](const char* name, const std::function<std::string(const ConeProfileFit&)>& cell) {
    auto& row = table.rows.emplace_back();
    row.emplace_back(name);
    for (const ConeProfileFit& profile : fit.profiles) row.emplace_back(cell(profile));
  };
  add_row("shape", [](const auto& p) { return files::shown_parameters(p.cone); });
  add_row("edge left open", edge_of);
  add_row("held by", [&](const auto& p) { return joined(active_constraints(p.cone, target)); });
  add_row("objective", [](const auto& p) { return fmt::format("{:.6g}", p.objective); });
  add_row("none is below", [](const auto& p) { return fmt::format("{:.6g}", p.lower_bound); });
  add_row("rms error", [](const auto& p) { return shown_rounded(percent_of(p.rms), 3) + " % of the peak"; });
  add_row("largest error", [](const auto& p) {
    return fmt::format("{} % at {:.4g} deg", shown_change(percent_of(p.largest_error), 3),
                       files::degrees(p.largest_error_angle));
  });
  add_row("flux error", [](const auto& p) { return percent(p.flux_error); });
  add_row("50 % angle off", [](const auto& p) { return percent(p.beam_angle_error); });
  add_row("10 % angle off", [](const auto& p) { return percent(p.field_angle_error); });
  add_row("lumens/candela",
          [](const auto& p) { return fmt::format("{:.4g}", flux_within(p.cone, files::radians(180))); });
  add_row("uncertainty", uncertainty_of);
  add_row("certificate", [](const auto& p) {
    return fmt::format("KKT {:.1e}, {} boxes, {} iterations", p.kkt_residual, p.boxes, p.iterations);
  });
  sheet.add(table);
  if (target.samples.empty()) return;

  command::Table residuals{.columns = {"angle_deg", "fraction"}};
  for (const ConeProfileFit& profile : fit.profiles) {
    residuals.columns.emplace_back(facts_of(profile.cone.profile).name);
    residuals.columns.emplace_back("error_%");
  }
  const double peak = peak_of(target.samples);
  sheet.add_samples(std::move(residuals), target.samples.size(), [&](std::size_t i) {
    const auto& sample = target.samples[i];
    Row row{files::degrees(sample.angle), sample.intensity / peak};
    for (const ConeProfileFit& profile : fit.profiles) {
      const double fraction = cone_at(profile.cone, std::cos(sample.angle));
      row.insert(row.end(), {fraction, percent_of(fraction - sample.intensity / peak)});
    }
    return row;
  });
}

/// The light's illuminance_at(): where the beam is brightest beside what is stated, else on the axis beside its peak's
/// by the inverse square.
void add_illuminance(Sheet& sheet, const LightFit& fit) {
  const LightTarget& target = fit.target;
  std::map<double, std::optional<double>> data_at;
  for (const double range : {1., 3., 10., 30., 100.}) {
    const bool has_data = target.light_peak && target.illuminance.empty();
    data_at[range] = has_data ? std::optional(*target.light_peak / (range * range)) : std::nullopt;
  }
  for (const auto& [range, lux] : target.illuminance) data_at[range] = lux;
  const bool is_clamped = fit.light.source_radius == 0;
  sheet.add_heading(fmt::format("Illuminance{}", is_clamped ? "" : " without the attenuation's clamp at 1"));
  command::Table table{.columns = {"range_m", "light_lx"}};
  if (target.light_peak) table.columns.insert(table.columns.end(), {"data_lx", "error_%"});
  const double angle = target.illuminance.empty() || fit.cookie ? 0 : fit.peak_angle;
  for (const auto& [range, data] : data_at) {
    const double lux = illuminance_at(fit.light, range, angle);
    Row& row = table.rows.emplace_back(Row{range, shown_rounded(lux, 6)});
    if (data) row.insert(row.end(), {shown_rounded(*data, 6), shown_change(percent_of(lux / *data - 1), 3)});
    row.resize(table.columns.size(), std::monostate());
  }
  sheet.add(table);
}

void add_asymmetry(Sheet& sheet, const LightFit& fit) {
  sheet.add("asymmetry", fmt::format("{:.3f} of the beam (rms) is not symmetric about the axis", fit.target.asymmetry));
}

void add_luminaire(Sheet& sheet, const LightFit& fit) {
  const Luminaire& luminaire = *fit.target.luminaire;
  const auto& distribution = luminaire.distribution;
  sheet.add_heading("Photometry");
  if (!luminaire.name.empty()) sheet.add("luminaire", luminaire.name);
  if (!luminaire.manufacturer.empty()) sheet.add("manufacturer", luminaire.manufacturer);
  sheet.add("axis", fmt::format("{}; the peak is {:.3g} deg off it", describe_axis(luminaire, fit.target.axis),
                                files::degrees(fit.peak_angle)));
  if (const auto stated = stated_flux(luminaire)) {
    sheet.add("stated flux", fmt::format("{} lm, from which the flux of the intensities differs by {}",
                                         shown_number(*stated), percent(luminous_flux(distribution) / *stated - 1)));
  }
  add_asymmetry(sheet, fit);
}

void add_elliptical_beam(Sheet& sheet, const LightFit& fit) {
  sheet.add_heading("Elliptical beam");
  for (const auto& [level, angles] : fit.target.ellipses) {
    sheet.add(fmt::format("at {} %", 100 * level),
              fmt::format("{} deg horizontally, {} deg vertically", files::shown_degrees(angles.horizontal),
                          files::shown_degrees(angles.vertical)));
  }
  add_asymmetry(sheet, fit);
}

// --- the report ---

std::string shown(const std::optional<double>& value) { return value ? shown_rounded(*value, 5) : "-"; }

/// "24", "24 x 6", "-".
std::string shown(const std::vector<double>& angles) {
  std::vector<std::string> texts;
  for (const double angle : angles) texts.push_back(shown_rounded(files::degrees(angle), 3));
  return texts.empty() ? "-" : fmt::format("{}", fmt::join(texts, " x "));
}

std::string line_of(std::string_view name, std::string_view first, std::string_view second, std::string_view rest) {
  std::string line = fmt::format("  {:<16}{:<16}{:<16}{}", name, first, second, rest);
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

/// The light's figure less the data's, where both are known and one.
std::string change_of(const std::optional<double>& data, const std::optional<double>& light) {
  return data && light && *data > 0 ? percent(*light / *data - 1) : "";
}
std::string change_of(const std::vector<double>& data, const std::vector<double>& light) {
  return data.size() == 1 && light.size() == 1 ? percent(light[0] / data[0] - 1) : "";
}

std::string shown_extent(const LightFit& fit) {
  return fit.range ? shown_rounded(compute_extent(fit.light.attenuation, fit.light.threshold), 4) : "-";
}

/// One of two lights.
std::string shown_part(const LightFit& fit) {
  const BeamData beam = light_beam(fit);
  return fmt::format("{} cd, {} lm, {} deg at 50 %, {} deg at 10 %, ends at {} m", shown(beam.peak), shown(beam.flux),
                     shown(beam.beam_angle), shown(beam.field_angle), shown_extent(fit));
}

/// The luminaire's candela on the axis if its beam is brighter elsewhere. A cone has its peak there.
std::optional<double> dimmer_axis(const LightFit& fit) {
  if (!fit.target.luminaire || fit.cookie) return std::nullopt;
  const auto& samples = fit.target.cone->samples;
  const double axis = samples.front().intensity;
  return axis < (1 - kGood.peak) * peak_of(samples) ? std::optional(axis) : std::nullopt;
}

/// How far the light, or both, are from what was measured.
std::string errors_of(const Outcome& outcome) {
  constexpr double kLeastAsymmetry = 0.001;  // shown as 0.1 %
  const LightFit& fit = *outcome.fit;
  std::vector<std::string> errors;
  if (const auto error = outcome.two ? outcome.two->beam_error : fit.beam_error()) {
    errors.push_back(fmt::format("{} % of the beam (rms){}", shown_rounded(percent_of(*error), 3),
                                 outcome.two || fit.cookie || fit.target.asymmetry < kLeastAsymmetry
                                     ? ""
                                     : ", asymmetry and cone together; the verdict judges each by itself"));
  } else if (fit.cone) {
    errors.push_back(fmt::format("{} % of the peak (rms)", shown_rounded(percent_of(fit.cone->best().rms), 3)));
  }
  if (fit.range && !fit.target.range->samples.empty()) {
    errors.push_back(fmt::format("falloff table {} % (rms), {} % at most",
                                 shown_rounded(percent_of(fit.range->rms_error), 3),
                                 shown_change(percent_of(fit.range->largest_error), 3)));
  }
  if (const auto& error = illuminance_error(outcome)) {
    errors.push_back(fmt::format("illuminance {} % at most", shown_change(percent_of(error->error), 3)));
  }
  return joined(errors);
}

}  // namespace

std::string format_report(const Outcome& outcome) {
  const LightFit& fit = *outcome.fit;
  const BeamData data = beam_data(fit), light = light_beam(outcome);
  std::string text = command::printable(fmt::format("{}, from {}", fit.light.name, fit.target.file)) + "\n";
  text += fmt::format("  {}: {}\n", name_of(outcome.verdict->grade), outcome.verdict->why);
  text += line_of("", "data", outcome.two ? "both lights" : "light", "");
  text += line_of("candela", shown(data.peak), shown(light.peak), change_of(data.peak, light.peak));
  if (const auto axis = dimmer_axis(fit)) {
    text += line_of("on the axis, cd", shown(axis), shown(light.peak), change_of(axis, light.peak));
  }
  text += line_of("lumens", shown(data.flux), shown(light.flux), change_of(data.flux, light.flux));
  text += line_of("50 % angle, deg", shown(data.beam_angle), shown(light.beam_angle),
                  change_of(data.beam_angle, light.beam_angle));
  text += line_of("10 % angle, deg", shown(data.field_angle), shown(light.field_angle),
                  change_of(data.field_angle, light.field_angle));
  if (outcome.two) {
    text += line_of("hot spot", shown_part(outcome.two->hot_spot), "", "");
    text += line_of("spill", shown_part(outcome.two->spill), "", "");
  } else {
    text += line_of("ends at, m", "", shown_extent(fit), "");
  }
  text += line_of("off by", errors_of(outcome), "", "");
  constexpr std::size_t kMaxLines = 15;
  std::size_t lines = std::size_t(std::ranges::count(text, '\n'));
  const std::size_t most = kMaxLines - lines - 1;
  for (std::size_t i = 0; i < std::min(most, outcome.advice.size()); ++i) text += "  - " + outcome.advice[i] + "\n";
  const std::size_t left = outcome.advice.size() - std::min(most, outcome.advice.size());
  text += fmt::format("  --details has {}\n",
                      left == 0 ? "more" : fmt::format("more, and {} more advice{}", left, left == 1 ? "" : "s"));
  return text;
}

std::string format_comparison(const Outcome& one, const Outcome& other) {
  std::string text = line_of("", "first", "second", "");
  const BeamData a = light_beam(*one.fit), b = light_beam(*other.fit);
  text = command::printable(fmt::format("first: {}, from {}", one.fit->light.name, one.fit->target.file)) + "\n" +
         command::printable(fmt::format("second: {}, from {}", other.fit->light.name, other.fit->target.file)) + "\n" +
         text;
  text += line_of("candela", shown(a.peak), shown(b.peak), change_of(a.peak, b.peak));
  text += line_of("lumens", shown(a.flux), shown(b.flux), change_of(a.flux, b.flux));
  text += line_of("50 % angle, deg", shown(a.beam_angle), shown(b.beam_angle), change_of(a.beam_angle, b.beam_angle));
  text +=
      line_of("10 % angle, deg", shown(a.field_angle), shown(b.field_angle), change_of(a.field_angle, b.field_angle));
  text += line_of("ends at, m", shown_extent(*one.fit), shown_extent(*other.fit), "");
  return text + line_of("verdict", name_of(one.verdict->grade), name_of(other.verdict->grade), "");
}

std::string format_details(const Outcome& outcome) {
  const LightFit& fit = *outcome.fit;
  Sheet sheet;
  sheet.add_heading("Light");
  for (std::size_t i = 0; i < fit.target.source.size(); ++i) sheet.add(i == 0 ? "source" : "", fit.target.source[i]);
  for (std::size_t i = 0; i < fit.target.derived.size(); ++i) {
    sheet.add(i == 0 ? "derived" : "", fit.target.derived[i]);
  }
  sheet.add("color", fmt::format("{} {} {}, linear RGB", shown_rounded(fit.light.color.r, 6),
                                 shown_rounded(fit.light.color.g, 6), shown_rounded(fit.light.color.b, 6)));
  if (fit.light.density_scale != 1) sheet.add("density scale", shown_number(fit.light.density_scale));
  if (fit.light.source_radius > 0) sheet.add("source radius", shown_rounded(fit.light.source_radius, 3) + " m");
  if (fit.target.luminaire) add_luminaire(sheet, fit);
  if (fit.elliptical_beam) add_elliptical_beam(sheet, fit);
  if (fit.range) {
    add_range(sheet, *fit.target.range, *fit.range);
    add_illuminance(sheet, fit);
  }
  if (fit.cone) add_cone(sheet, *fit.target.cone, *fit.cone);
  if (!outcome.advice.empty()) sheet.add_heading("Advice");
  for (const std::string& sentence : outcome.advice) sheet.add("-", sentence);
  return sheet.text();
}

}  // namespace litfog::fit
