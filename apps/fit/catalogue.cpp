// SPDX-License-Identifier: Apache-2.0
#include "fit/catalogue.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <time.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "command/html_text.h"
#include "files/whole_file.h"
#include "fit/fit_figure.h"
#include "fit/fog_picture.h"
#include "litfog/files/output_error.h"
#include "text/shown_number.h"

namespace litfog::fit {
namespace {

namespace fs = std::filesystem;
using Cell = command::Table::Cell;
using Json = nlohmann::json;
using command::html_link;
using command::html_text;

constexpr const char* kLamps = "lamps";
constexpr const char* kPage = "index.html";
constexpr const char* kFirstLine = "<!DOCTYPE html><!-- a catalogue of litfog-fit -->";  // of the page
constexpr const char* kProgram = "/proc/self/exe";
constexpr std::array kEndings{".json", ".svg", ".png"};  // of a lamp's files beside its record

// --- records ---

/// The time as files have it, which lags behind other clocks.
timespec file_time() {
  timespec time;
  clock_gettime(CLOCK_REALTIME_COARSE, &time);
  return time;
}

bool has_changed_since(const timespec& time, const std::string& file) {
  struct stat status;
  if (stat(file.c_str(), &status) != 0) return true;
  return std::pair(status.st_ctim.tv_sec, status.st_ctim.tv_nsec) >= std::pair(time.tv_sec, time.tv_nsec);
}

/// A file as it was: nothing can have been changed in it that leaves both size and time.
Json state_of(const std::string& file) {
  struct stat status;
  if (stat(file.c_str(), &status) != 0) return nullptr;
  return {file, status.st_size, status.st_mtim.tv_sec, status.st_mtim.tv_nsec};
}

Json json_of(const Cell& cell) {
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  const double* const number = std::get_if<double>(&cell);
  if (number == nullptr) return nullptr;
  return std::isfinite(*number) ? Json(*number) : Json(fmt::format("{}", *number));  // which JSON has no number for
}

Cell cell_of(const Json& json) {
  if (json.is_number()) return json.get<double>();
  if (json == "inf") return std::numeric_limits<double>::infinity();
  if (json.is_string()) return json.get<std::string>();
  return std::monostate();
}

/// written  the outcome's files as they are to be found again
/// begun    before the files it was made from were read: one that has changed since then may have been read as it was
///          or is
std::string record_of(const Outcome& outcome, const Summary& summary, const std::string& options,
                      const std::vector<std::string>& written, const timespec& begun) {
  Json states = Json::array({state_of(kProgram)});
  for (const std::string& file : files_of(outcome.input, outcome.fit->target)) {
    const Json state = state_of(file);
    states.push_back(has_changed_since(begun, file) ? Json() : state);
  }
  for (const std::string& file : written) states.push_back(state_of(file));
  Json row = Json::array();
  for (const Cell& cell : summary.row) row.push_back(json_of(cell));
  return Json{{"input", outcome.input.path}, {"options", options},           {"files", states},
              {"status", summary.status},    {"messages", summary.messages}, {"row", row},
              {"report", summary.report}}
      .dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// The record's, or nothing where it is none or not of today.
std::optional<Summary> summary_of_record(const fs::path& path, const Input& input, const std::string& options) {
  std::ifstream file(path, std::ios::binary);
  const Json record = Json::parse(file, nullptr, false);
  try {
    if (record.at("input") != input.path || record.at("options") != options) return std::nullopt;
    for (const Json& state : record.at("files")) {
      if (state.is_null() || state_of(state.at(0).get<std::string>()) != state) return std::nullopt;
    }
    Summary summary{.status = record.at("status").get<command::ExitStatus>(),
                    .messages = record.at("messages"),
                    .row = {},
                    .report = record.at("report")};
    for (const Json& cell : record.at("row")) summary.row.push_back(cell_of(cell));
    if (summary.row.size() != summary_columns().size()) return std::nullopt;
    return summary;
  } catch (const Json::exception&) {  // of another version, or broken
    return std::nullopt;
  }
}

// --- page ---

constexpr const char* kPageBegin = R"({first_line}
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width">
<title>Lights</title>
<style>
body {{ margin: 0 auto; max-width: 110rem; padding: 0 1.5rem 3rem; color: #222; background: #fff;
  font: 0.9375rem/1.45 "DejaVu Sans", Verdana, system-ui, sans-serif; }}
h1 {{ font-size: 1.5rem; }}
h2 {{ font-size: 1.15rem; margin: 0; }}
p {{ margin: 0.2rem 0; max-width: 70rem; }}
table {{ border-collapse: collapse; font-size: 0.8125rem; }}
th, td {{ padding: 0.15rem 0.6rem; text-align: right; border-bottom: 1px solid #ddd; white-space: nowrap; }}
th:first-child, td:first-child {{ text-align: left; }}
th {{ position: sticky; top: 0; background: #fff; }}
.scroll {{ overflow-x: auto; }}
.good {{ color: #00734f; }} .fair {{ color: #8a5a00; }} .poor {{ color: #b03a00; }}
section {{ margin-top: 2rem; padding-top: 1rem; border-top: 2px solid #ddd; content-visibility: auto;
  contain-intrinsic-size: auto 60rem; }}
figure {{ margin: 0.5rem 0; }}
figure img {{ max-width: 100%; height: auto; }}
figcaption {{ font-size: 0.8125rem; color: #666; }}
</style></head><body>
<h1>{heading}</h1>
<p>Errors are fit less data. A beam's asymmetry is the part of it (rms) that no cone can follow. In fog a light is seen
from 30 m beside its beam, the frame is {metres} m wide, visibility {near}, and all lights have one exposure.</p>
<div class="scroll"><table><thead><tr><th>light</th><th>extent m</th><th>cone</th><th>rms %</th><th>flux %</th>
<th>asymmetry</th><th>range %</th><th>verdict</th><th>advice</th></tr></thead><tbody>
)";

std::string visibilities() {
  std::string text;
  for (const double metres : kFogPictureVisibilities) text += fmt::format("{}{:g} m", text.empty() ? "" : ", ", metres);
  return text;
}

std::string text_of(const Cell& cell) {
  if (const double* number = std::get_if<double>(&cell)) {
    return shown_rounded(*number, 3);
  }
  if (const auto* text = std::get_if<std::string>(&cell)) return html_text(*text);
  return "";
}

/// A cell of a summary by its column.
const Cell& cell_of(const Summary& summary, std::string_view column) {
  const auto& columns = summary_columns();
  return summary.row[std::size_t(std::ranges::find(columns, column) - columns.begin())];
}

bool has_light(const Summary& summary) { return !text_of(cell_of(summary, "verdict")).empty(); }

/// "40 lights", "1 light of 3 files".
std::string heading_of(const std::vector<Summary>& summaries) {
  const auto count = std::size_t(std::ranges::count_if(summaries, has_light));
  const std::string lights = fmt::format("{} light{}", count, count == 1 ? "" : "s");
  return count == summaries.size() ? lights : fmt::format("{} of {} files", lights, summaries.size());
}

std::string table_row(const Input& input, const Summary& summary) {
  const std::string verdict = text_of(cell_of(summary, "verdict"));
  std::string html = verdict.empty() ? fmt::format("<tr><td>{}</td>", html_text(input.path))
                                     : fmt::format("<tr class=\"{}\"><td><a href=\"#{}\">{}</a></td>", verdict,
                                                   html_link(input.name), html_text(input.name));
  for (const char* column : {"extent_m", "cone", "rms_%", "flux_%", "asymmetry", "range_%"}) {
    html += fmt::format("<td>{}</td>", text_of(cell_of(summary, column)));
  }
  return html + fmt::format("<td>{}</td><td>{}</td></tr>\n", verdict.empty() ? "no light" : verdict,
                            text_of(cell_of(summary, "advice")));
}

std::string section(const Input& input, const Summary& summary) {
  const Json report = Json::parse(summary.report);
  const std::string link = std::string(kLamps) + "/" + html_link(input.name);
  std::string html = fmt::format(
      "<section id=\"{}\"><h2>{}</h2>\n<p>{} · <a href=\"{}.json\">light</a></p>\n"
      "<p class=\"{}\">{}: {}</p>\n",
      html_link(input.name), html_text(report["light"].value("name", input.name)), html_text(input.path), link,
      report["verdict"].get<std::string>(), report["verdict"].get<std::string>(),
      html_text(report["why"].get<std::string>()));
  for (const Json& sentence : report["advice"])
    html += fmt::format("<p>{}</p>\n", html_text(sentence.get<std::string>()));
  html += fmt::format("<figure><img loading=\"lazy\" alt=\"fit and data\" src=\"{}.svg\"></figure>\n", link);
  html += fmt::format(
      "<figure><img loading=\"lazy\" alt=\"in fog\" src=\"{}.png\"><figcaption>Visibility {}"
      "</figcaption></figure></section>\n",
      link, visibilities());
  return html;
}

}  // namespace

Catalogue::Catalogue(const std::string& folder, const std::string& options, const std::vector<Input>& inputs)
    : folder_(folder), options_(options), begun_(file_time()) {
  expect_own_page();
  for (const Input& input : inputs) {
    if (!input.error) expect_own_files(input);
  }
  std::error_code error;
  fs::create_directory(folder_, error);
  if (!error) fs::create_directory(folder_ / kLamps, error);
  if (error) throw OutputError(fmt::format("{}: cannot be made: {}", folder, error.message()));
  files::remove_stale_temporaries(folder_);
}

void Catalogue::expect_own_page() const {
  std::error_code error;
  const fs::path page = folder_ / kPage;
  if (!fs::exists(page, error)) return;
  std::ifstream file(page);
  std::string first_line;
  std::getline(file, first_line);
  if (first_line == kFirstLine) return;
  throw OutputError(fmt::format("{}: cannot be written: is there, and is no catalogue's page", page.string()));
}

void Catalogue::expect_own_files(const Input& input) const {
  std::error_code error;
  if (fs::exists(file_of(input, ".record"), error)) return;
  for (const char* ending : kEndings) {
    const fs::path file = file_of(input, ending);
    if (!fs::exists(file, error)) continue;
    throw OutputError(fmt::format("{}: cannot be written: is there, and is no catalogue's: it has no {}.record",
                                  file.string(), input.name));
  }
}

fs::path Catalogue::file_of(const Input& input, const char* ending) const {
  return folder_ / kLamps / (input.name + ending);
}

std::string Catalogue::light_path(const Input& input) const { return file_of(input, ".json").string(); }

std::optional<Summary> Catalogue::find(const Input& input) const {
  if (input.error) return std::nullopt;
  return summary_of_record(file_of(input, ".record"), input, options_);
}

void Catalogue::add(const std::vector<FittedLamp>& lamps) const {
  std::vector<command::Figure> figures;
  for (const auto& [outcome, summary] : lamps) figures.push_back(fit_figure({&*outcome.fit}));
  const std::vector<std::string> drawn = command::draw_svg_figures(figures);
  for (std::size_t i = 0; i < lamps.size(); ++i) {
    const auto& [outcome, summary] = lamps[i];
    const auto write = [&, &input = outcome.input](const char* ending, std::string_view text) {
      files::write_whole_file(file_of(input, ending).string(), text);
    };
    write(".record", "{}");  // from now on the files are the catalogue's, and not done
    write(".svg", drawn[i]);
    write(".png", draw_fog_picture(outcome.fit->light));
    write(".json", outcome.light);
    std::vector<std::string> written;
    for (const char* ending : kEndings) written.push_back(file_of(outcome.input, ending).string());
    write(".record", record_of(outcome, summary, options_, written, begun_));
  }
}

void Catalogue::write_page(const std::vector<Input>& inputs, const std::vector<Summary>& summaries) const {
  std::string html = fmt::format(fmt::runtime(kPageBegin), fmt::arg("first_line", kFirstLine),
                                 fmt::arg("heading", heading_of(summaries)), fmt::arg("metres", kFogPictureMetres),
                                 fmt::arg("near", visibilities()));
  for (std::size_t i = 0; i < inputs.size(); ++i) html += table_row(inputs[i], summaries[i]);
  html += "</tbody></table></div>\n";
  for (const Summary& summary : summaries) {
    if (has_light(summary)) continue;
    for (const std::string& message : summary.messages) {
      html += fmt::format("<p class=\"poor\">{}</p>\n", html_text(message));
    }
  }
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (has_light(summaries[i])) html += section(inputs[i], summaries[i]);
  }
  files::write_whole_file((folder_ / kPage).string(), html + "</body></html>\n");
}

}  // namespace litfog::fit
