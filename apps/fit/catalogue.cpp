// SPDX-License-Identifier: Apache-2.0
#include "fit/catalogue.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <nlohmann/json.hpp>

#include "command/html_text.h"
#include "files/whole_file.h"
#include "fit/light_pictures.h"
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
/// The page's first line, by which a folder is known to be a catalogue's.
constexpr const char* kFirstLine = "<!DOCTYPE html><!-- a catalogue of litfog-fit -->";
constexpr std::array kEndings{".json", ".svg", ".png"};  // a lamp's files

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
th:nth-child(2), td:nth-child(2) {{ text-align: left; }}
td img {{ display: block; height: 2rem; }}
th {{ position: sticky; top: 0; background: #fff; cursor: pointer; }}
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
from 30 m beside its beam, the frame is {metres} m wide, visibility {near}, and all lights have one exposure.
A click on a column's name sorts by it.</p>
<div class="scroll"><table><thead><tr><th></th><th>light</th><th>candela</th><th>lumens</th><th>50 % angle</th>
<th>10 % angle</th><th>extent m</th><th>rms %</th><th>flux %</th><th>asymmetry</th><th>range %</th><th>verdict</th>
<th>advice</th></tr></thead><tbody>
)";

/// Sorts the table by the column whose name is clicked: numbers from the largest or, at the second click, the smallest.
constexpr const char* kPageEnd = R"(<script>
const body = document.querySelector("tbody");
document.querySelectorAll("th").forEach((name, column) => name.onclick = () => {
  const key = row => row.cells[column]?.dataset.value ?? row.cells[column]?.textContent ?? "";
  const turn = name.dataset.turn = name.dataset.turn == 1 ? -1 : 1;
  const compare = (a, b) => isNaN(a) || isNaN(b) ? a.localeCompare(b) : b - a;
  body.append(...[...body.rows].sort((a, b) => (key(a) == "") - (key(b) == "") || turn * compare(key(a), key(b))));
});
</script></body></html>
)";

bool is_own_page(const std::string& page) {
  std::ifstream file(page);
  std::string first_line;
  return std::getline(file, first_line) && first_line == kFirstLine;
}

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
  std::string html = verdict.empty()
                         ? fmt::format("<tr><td></td><td>{}</td>", html_text(input.path))
                         : fmt::format(
                               "<tr class=\"{0}\"><td><img loading=\"lazy\" alt=\"\" src=\"{1}/{2}.png\"></td>"
                               "<td><a href=\"#{2}\">{3}</a></td>",
                               verdict, kLamps, html_link(input.name), html_text(input.name));
  for (const char* column :
       {"candela", "lumens", "50_%_deg", "10_%_deg", "extent_m", "rms_%", "flux_%", "asymmetry", "range_%"}) {
    const Cell& cell = cell_of(summary, column);
    const double* const number = std::get_if<double>(&cell);
    html += fmt::format("<td data-value=\"{}\">{}</td>", number ? fmt::format("{}", *number) : "", text_of(cell));
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

Catalogue::Catalogue(const std::string& folder, const std::vector<Input>& inputs) : folder_(folder) {
  std::error_code error;
  const std::string page = (folder_ / kPage).string();
  const bool is_ours = is_own_page(page);
  if (!is_ours && fs::exists(page, error)) {
    throw OutputError(fmt::format("{}: cannot be written: exists, and is no catalogue's page", page));
  }
  for (const Input& input : inputs) {
    for (const char* ending : kEndings) {
      if (is_ours || input.error || !fs::exists(file_of(input, ending), error)) continue;
      throw OutputError(fmt::format("{}: cannot be written: exists, and {} has no catalogue's page",
                                    file_of(input, ending), folder));
    }
  }
  fs::create_directory(folder_, error);
  if (!error) fs::create_directory(folder_ / kLamps, error);
  if (error) throw OutputError(fmt::format("{}: cannot be made: {}", folder, error.message()));
  files::remove_stale_temporaries(folder_);
  // From now on the lamps' files are the catalogue's, also where this run is ended before it writes the page.
  if (!is_ours) files::write_whole_file(page, std::string(kFirstLine) + "\n");
}

std::string Catalogue::file_of(const Input& input, const char* ending) const {
  return (folder_ / kLamps / (input.name + ending)).string();
}

std::string Catalogue::light_path(const Input& input) const { return file_of(input, ".json"); }

void Catalogue::add(const std::vector<const Outcome*>& outcomes) const {
  std::vector<command::Figure> figures;
  for (const Outcome* outcome : outcomes) figures.push_back(fit_figure({&*outcome->fit}));
  const std::vector<std::string> drawn = command::draw_svg_figures(figures);
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    const Outcome& outcome = *outcomes[i];
    files::write_whole_file(file_of(outcome.input, ".svg"), drawn[i]);
    files::write_whole_file(file_of(outcome.input, ".png"), draw_fog_picture(outcome.fit->light));
    files::write_whole_file(file_of(outcome.input, ".json"), outcome.light);
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
  files::write_whole_file((folder_ / kPage).string(), html + kPageEnd);
}

}  // namespace litfog::fit
