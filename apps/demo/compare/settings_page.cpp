// SPDX-License-Identifier: Apache-2.0
#include "demo/compare/pages.h"

#include <fmt/format.h>

#include <cmath>

#include "command/html_text.h"
#include "command/printable.h"
#include "demo/compare/page_text.h"
#include "drawing/heat_map.h"
#include "files/json_text.h"
#include "measure/frame_times.h"

namespace litfog::demo {
namespace {

using command::data_uri;
using command::html_text;

/// A text as a string of the script. Escapes "<", because "</script>" would end it.
std::string script_text(const std::string& text) {
  std::string quoted;
  for (const char c : files::json_quoted(command::printable(text))) quoted += c == '<' ? "\\u003c" : std::string(1, c);
  return quoted;
}

std::string picture_text(const std::string& png) { return '"' + data_uri("image/png", png) + '"'; }

std::string row(const std::vector<SettingResult>& settings, std::size_t i, const PairResult* from_first) {
  const SettingResult& setting = settings[i];
  return fmt::format(
      "<tr><th scope=\"row\">{}</th><td class=\"words\">{}</td><td><span title=\"10th to 90th percentile: {} "
      "ms\">{}</span></td><td>{:.2f}</td><td>{}</td><td>{}</td></tr>\n",
      i + 1, html_text(setting.text), measure::milliseconds_text(setting.spread),
      measure::milliseconds_text(setting.milliseconds), setting.milliseconds / settings.front().milliseconds,
      from_first ? error_text(from_first->largest) : "", from_first ? error_text(from_first->mean) : "");
}

}  // namespace

std::string settings_page(const SettingsFacts& facts, const std::vector<SettingResult>& settings,
                          const std::vector<PairResult>& pairs) {
  std::string rows;
  std::string choices;
  std::string names;
  std::string pictures;
  std::string differences;
  for (std::size_t i = 0; i < settings.size(); ++i) {
    const SettingResult& setting = settings[i];
    rows += row(settings, i, i == 0 ? nullptr : &pairs[i - 1]);
    choices += fmt::format("<option value=\"{}\">{}: {}</option>", i, i + 1, html_text(setting.text));
    names += (i == 0 ? "" : ", ") + script_text(setting.text);
    pictures += (i == 0 ? "\n" : ",\n") + picture_text(setting.png);
  }
  for (const PairResult& pair : pairs) {
    differences += fmt::format("{}\n{{first: {}, second: {}, largest: \"{}\", mean: \"{}\", picture: {}}}",
                               differences.empty() ? "" : ",", pair.first, pair.second, error_text(pair.largest),
                               error_text(pair.mean), picture_text(pair.png));
  }
  return filled("settings.html", fmt::arg("style", page_text("comparison.css")),
                fmt::arg("settings_style", page_text("settings.css")), fmt::arg("script", page_text("settings.js")),
                fmt::arg("title", html_text(facts.title)), fmt::arg("machine", html_text(facts.machine)),
                fmt::arg("width", facts.width), fmt::arg("height", facts.height), fmt::arg("frames", facts.frames),
                fmt::arg("count", settings.size()), fmt::arg("rows", rows), fmt::arg("choices", choices),
                fmt::arg("least", drawing::kHeatLeast), fmt::arg("gradient", heat_gradient()),
                fmt::arg("most", drawing::kHeatLeast * std::pow(10.0, drawing::kHeatDecades)),
                fmt::arg("names", "[" + names + "]"), fmt::arg("pictures", "[" + pictures + "]"),
                fmt::arg("differences", "[" + differences + "]"));
}

}  // namespace litfog::demo
