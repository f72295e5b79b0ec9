// SPDX-License-Identifier: Apache-2.0
#include "fit/data_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <utility>

#include "command/printable.h"
#include "command/table.h"
#include "files/cone_json.h"
#include "fit/advice.h"
#include "fit/verdict.h"
#include "litfog/color_temperature.h"
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

/// The light's illuminance on its axis beside its peak's by the inverse square.
void add_illuminance(Sheet& sheet, const LightFit& fit) {
  const Light near = photometric(fit.light);
  const auto& peak = fit.target.light_peak;
  sheet.add_heading("Illuminance");
  command::Table table{.columns = {"range_m", "light_lx"}};
  if (peak) table.columns.insert(table.columns.end(), {"data_lx", "error_%"});
  for (const double range : {1., 3., 10., 30., 100.}) {
    const double lux = kWhiteLux * luminance(near.color) * attenuation_at(near.attenuation, range);
    Row& row = table.rows.emplace_back(Row{range, shown_rounded(lux, 6)});
    if (!peak) continue;
    const double data = *peak / (range * range);
    row.insert(row.end(), {shown_rounded(data, 6), shown_change(percent_of(lux / data - 1), 3)});
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
  const bool is_photometric = fit.target.axis == kPhotometricAxis;
  if (!is_photometric) sheet.add("axis", describe_axis(luminaire, fit.target.axis));
  sheet.add("peak", fmt::format("{} cd, {:.3g} deg off {}", shown_number(fit.target.luminaire_peak.intensity),
                                files::degrees(fit.peak_angle), is_photometric ? "the photometric axis" : "that axis"));
  const auto stated = stated_flux(luminaire);
  const double flux = luminous_flux(distribution);
  sheet.add("flux", fmt::format("{} lm", shown_number(flux)) +
                        (stated ? fmt::format(", stated {} lm ({} %)", shown_number(*stated),
                                              shown_change(100 * (flux / *stated - 1), 2))
                                : ""));
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

}  // namespace

std::string format_data_sheet(const LightFit& fit) {
  Sheet sheet;
  sheet.add("light", fit.light.name);
  sheet.add("from", fit.target.file);
  for (std::size_t i = 0; i < fit.target.source.size(); ++i) sheet.add(i == 0 ? "source" : "", fit.target.source[i]);
  for (std::size_t i = 0; i < fit.target.derived.size(); ++i) {
    sheet.add(i == 0 ? "derived" : "", fit.target.derived[i]);
  }
  sheet.add("color", fmt::format("{} {} {}, linear RGB", shown_rounded(fit.light.color.r, 6),
                                 shown_rounded(fit.light.color.g, 6), shown_rounded(fit.light.color.b, 6)));
  if (fit.light.density_scale != 1) sheet.add("density scale", shown_number(fit.light.density_scale));
  const double peak = luminance(candela(fit.light));
  if (std::isfinite(peak)) sheet.add("candela", shown_rounded(peak, 9));
  if (fit.light.source_radius > 0) sheet.add("source radius", shown_rounded(fit.light.source_radius, 3) + " m");
  if (fit.flux) {
    const char* const shape = fit.cookie ? " by its cookie" : fit.cone ? " by its cone" : "";
    sheet.add("light's flux",
              fmt::format("{} lm{}", shown_number(*fit.flux), shape) +
                  (fit.flux_error ? fmt::format("; {} of the data's flux", percent(fit.flux_error)) : ""));
  }
  const Verdict verdict = judge(fit);
  sheet.add("verdict", fmt::format("{}: {}", name_of(verdict.grade), verdict.why));
  if (fit.target.luminaire) add_luminaire(sheet, fit);
  if (fit.elliptical_beam) add_elliptical_beam(sheet, fit);
  if (fit.range) {
    add_range(sheet, *fit.target.range, *fit.range);
    add_illuminance(sheet, fit);
  }
  if (fit.cone) add_cone(sheet, *fit.target.cone, *fit.cone);
  const auto advice = advice_on(fit);
  if (!advice.empty()) sheet.add_heading("Advice");
  for (const std::string& sentence : advice) sheet.add("-", sentence);
  return sheet.text();
}

}  // namespace litfog::fit
