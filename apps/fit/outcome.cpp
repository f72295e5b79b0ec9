// SPDX-License-Identifier: Apache-2.0
#include "fit/outcome.h"

#include <fmt/format.h>

#include <CLI/Error.hpp>
#include <algorithm>
#include <exception>
#include <filesystem>
#include <new>
#include <utility>

#include "files/angle_deg.h"
#include "files/json_text.h"
#include "litfog/attenuation.h"
#include "litfog/files/output_error.h"
#include "litfog/input_error.h"

namespace litfog::fit {
namespace {

namespace fs = std::filesystem;
using Cell = command::Table::Cell;

std::string status_of(const Outcome& outcome) {
  if (!outcome.fit) return "error";
  const auto& [range, cone] = std::pair(outcome.fit->range, outcome.fit->cone);
  if (range && range->status != AttenuationFitStatus::optimal) return name_of(range->status);
  return cone ? name_of(cone->best().status) : "optimal";
}

/// Why there is no light, or why the status is 5, a sentence each.
std::vector<std::string> messages_of(const Outcome& outcome) {
  if (!outcome.fit) return {outcome.reason};
  std::vector<std::string> messages;
  if (outcome.status != command::kNotToTolerance) return messages;
  const auto& [range, cone] = std::pair(outcome.fit->range, outcome.fit->cone);
  const std::string& input = outcome.input.path;
  if (range && range->status != AttenuationFitStatus::optimal) {
    messages.push_back(fmt::format("{}: range: {}: {}", input, name_of(range->status), range->sentence));
  }
  if (cone && cone->best().status != ConeFitStatus::optimal) {
    messages.push_back(fmt::format("{}: cone: unproven: its objective is {:.6g}, another may have {:.6g}", input,
                                   cone->best().objective, cone->best().lower_bound));
  }
  if (outcome.fit->is_proven()) messages.push_back(fmt::format("{}: poor: {}", input, outcome.verdict->why));
  return messages;
}

std::string number_or_null(const std::optional<double>& value) { return value ? fmt::format("{}", *value) : "null"; }

std::string json_of(const BeamData& beam) {
  const auto angles = [](const std::vector<double>& radians) -> std::string {
    if (radians.empty()) return "null";
    if (radians.size() == 1) return fmt::format("{}", files::degrees(radians[0]));
    return fmt::format("[{}, {}]", files::degrees(radians[0]), files::degrees(radians[1]));
  };
  return fmt::format(R"({{"peak_cd": {}, "flux_lm": {}, "beam_angle_deg": {}, "field_angle_deg": {}}})",
                     number_or_null(beam.peak), number_or_null(beam.flux), angles(beam.beam_angle),
                     angles(beam.field_angle));
}

/// The beam of what is written, and its errors.
std::string light_beam_json(const Outcome& outcome) {
  std::string beam = json_of(light_beam(outcome));
  beam.pop_back();
  const LightFit& fit = *outcome.fit;
  const auto& two = outcome.two;
  const auto& illuminance = illuminance_error(outcome);
  return fmt::format(R"({}, "flux_error": {}, "peak_error": {}, "illuminance_error": {}, "beam_error": {}}})", beam,
                     number_or_null(two ? two->flux_error : fit.flux_error),
                     number_or_null(two ? two->peak_error : fit.peak_error),
                     number_or_null(illuminance ? std::optional(illuminance->error) : std::nullopt),
                     number_or_null(two ? two->beam_error : fit.beam_error()));
}

std::string json_of(const std::vector<std::string>& sentences) {
  std::string text;
  for (const std::string& sentence : sentences) text += (text.empty() ? "" : ", ") + files::json_quoted(sentence);
  return "[" + text + "]";
}

std::string json_of(const Outcome& outcome) {
  const auto text_or_null = [](const std::string& value) { return value.empty() ? "null" : files::json_quoted(value); };
  const bool has_axis = outcome.fit && outcome.fit->target.luminaire;
  std::string text = fmt::format(
      "{{\"input\": {}, \"output\": {}, \"status\": \"{}\", \"reason\": {},\n\"verdict\": {}, \"why\": {},\n"
      "\"beam\": {},\n\"light_beam\": {},\n\"axis\": {},\n\"derived\": {},\n\"advice\": {},\n",
      files::json_quoted(outcome.input.path), text_or_null(outcome.output), status_of(outcome),
      text_or_null(outcome.reason), text_or_null(outcome.verdict ? name_of(outcome.verdict->grade) : ""),
      text_or_null(outcome.verdict ? outcome.verdict->why : ""),
      outcome.fit ? json_of(beam_data(*outcome.fit)) : "null", outcome.fit ? light_beam_json(outcome) : "null",
      text_or_null(has_axis ? describe_axis(*outcome.fit->target.luminaire, outcome.fit->target.axis) : ""),
      outcome.fit ? json_of(outcome.fit->target.derived) : "[]", json_of(outcome.advice));
  text += "\"light\": " + (outcome.fit ? outcome.light : std::string("null"));
  while (text.ends_with('\n')) text.pop_back();
  if (outcome.two) text += ",\n\"spill\": " + outcome.spill;
  while (text.ends_with('\n')) text.pop_back();
  return text + "}";
}

Cell percent_or_none(const std::optional<double>& fraction) {
  return fraction ? Cell(100 * *fraction) : Cell(std::monostate());
}

Cell number_or_none(const std::optional<double>& number) { return number ? Cell(*number) : Cell(std::monostate()); }

std::vector<Cell> row_of(const Outcome& outcome) {
  std::vector<Cell> row{outcome.input.path};
  if (outcome.fit) {
    const LightFit& fit = *outcome.fit;
    const BeamData light = light_beam(outcome), data = beam_data(fit);
    const auto angle = [](const std::vector<double>& angles) {
      return angles.empty() ? Cell(std::monostate()) : Cell(files::degrees(std::ranges::max(angles)));
    };
    row.insert(row.end(), {compute_extent(fit.light.attenuation, fit.light.threshold), number_or_none(light.peak),
                           number_or_none(data.peak), number_or_none(light.flux), number_or_none(data.flux),
                           angle(light.beam_angle), angle(light.field_angle)});
    const bool is_one = fit.cone && !outcome.two;
    row.push_back(percent_or_none(is_one ? std::optional(fit.cone->best().rms) : std::nullopt));
    row.push_back(percent_or_none(outcome.two ? std::optional(outcome.two->flux_error)
                                  : is_one    ? fit.cone->best().flux_error
                                              : std::nullopt));
    row.push_back(fit.beam() ? Cell(fit.target.asymmetry) : Cell(std::monostate()));
    const bool has_samples = fit.range && !fit.target.range->samples.empty();
    const auto& illuminance = illuminance_error(outcome);
    row.push_back(percent_or_none(has_samples   ? std::optional(fit.range->largest_error)
                                  : illuminance ? std::optional(illuminance->error)
                                                : std::nullopt));
    row.insert(row.end(), {name_of(outcome.verdict->grade), double(outcome.advice.size())});
  }
  row.resize(summary_columns().size() - 1, std::monostate());
  row.emplace_back(status_of(outcome));
  return row;
}

}  // namespace

const std::optional<IlluminanceError>& illuminance_error(const Outcome& outcome) {
  return outcome.two ? outcome.two->illuminance_error : outcome.fit->illuminance_error;
}

BeamData light_beam(const Outcome& outcome) { return outcome.two ? outcome.two->beam : light_beam(*outcome.fit); }

void fail(Outcome& outcome) {
  const auto set = [&outcome](command::ExitStatus status, const std::string& reason) {
    outcome.fit.reset();
    outcome.two.reset();
    outcome.verdict.reset();
    outcome.advice.clear();
    outcome.status = status;
    outcome.reason = reason;
  };
  const std::string& input = outcome.input.path;
  try {
    throw;
  } catch (const CLI::Error&) {
    throw;
  } catch (const InputError& error) {
    set(command::kBadInput, error.what());
  } catch (const OutputError& error) {
    set(command::kCannotWrite, fmt::format("{}: {}", input, error.what()));
  } catch (const command::MissingCapability& error) {
    set(command::kMissingCapability, fmt::format("{}: {}", input, error.what()));
  } catch (const std::bad_alloc&) {
    set(command::kInternalError, fmt::format("{}: out of memory", input));
  } catch (const std::exception& error) {
    set(command::kInternalError, fmt::format("{}: internal error: {}", input, error.what()));
  }
}

const std::vector<std::string>& summary_columns() {
  static const std::vector<std::string> columns{"input",     "extent_m", "candela",  "data_cd", "lumens",
                                                "data_lm",   "50_%_deg", "10_%_deg", "rms_%",   "flux_%",
                                                "asymmetry", "range_%",  "verdict",  "advice",  "status"};
  return columns;
}

Summary summary_of(const Outcome& outcome, bool has_report) {
  return {.status = outcome.status,
          .messages = messages_of(outcome),
          .row = row_of(outcome),
          .report = has_report ? json_of(outcome) : ""};
}

std::vector<std::string> files_of(const Input& input, const LightTarget& target) {
  std::vector<std::string> files{input.path};
  if (target.luminaire) files.push_back(target.luminaire->file);
  if (target.luminaire && target.luminaire->tilt && !target.luminaire->tilt->file.empty()) {
    files.push_back(target.luminaire->tilt->file);
  }
  for (std::string& file : files) {  // within a container: the container
    std::error_code error;
    while (!fs::exists(file, error) && fs::path(file).has_parent_path()) file = fs::path(file).parent_path().string();
  }
  return files;
}

}  // namespace litfog::fit
