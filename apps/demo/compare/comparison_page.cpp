// SPDX-License-Identifier: Apache-2.0
#include "demo/compare/pages.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "command/html_text.h"
#include "demo/compare/page_text.h"
#include "drawing/heat_map.h"
#include "measure/frame_times.h"

namespace litfog::demo {
namespace {

using command::html_link;
using command::html_text;

std::string figure(const SceneResult& scene, const PathResult& result) {
  const render::LightingPath& path = *result.path;
  return filled(
      "path.html", fmt::arg("scene", html_text(scene.name)), fmt::arg("path", html_text(path.name)),
      fmt::arg("source", html_text(path.source)), fmt::arg("description", html_text(path.description)),
      fmt::arg("drawn_file", html_link(scene.drawn_file(path))),
      fmt::arg("error_file", html_link(scene.error_file(path))),
      fmt::arg("reference_file", html_link(scene.reference_file(path))),
      fmt::arg("milliseconds", measure::milliseconds_text(result.milliseconds)),
      fmt::arg("spread", measure::milliseconds_text(result.spread)), fmt::arg("over_legacy", result.over_legacy),
      fmt::arg("largest_error", error_text(result.largest_error)),
      fmt::arg("mean_error", error_text(result.mean_error)),
      fmt::arg("excluded", result.excluded == 0 ? "" : fmt::format(" &middot; pixels excluded: {}", result.excluded)));
}

std::string section(const SceneResult& scene, std::size_t number) {
  const render::LightingPath& path = *scene.paths.front().path;
  std::string figures;
  for (const PathResult& result : scene.paths) figures += figure(scene, result);
  return filled("scene.html", fmt::arg("number", number), fmt::arg("name", html_text(scene.name)),
                fmt::arg("description", html_text(scene.description)),
                fmt::arg("conditions", html_text(scene.conditions)), fmt::arg("lights", scene.lights),
                fmt::arg("sheet", html_link(scene.sheet_file())),
                fmt::arg("reference", html_link(scene.reference_file(path))), fmt::arg("path", html_text(path.name)),
                fmt::arg("figures", figures));
}

/// A path's row of the table: a pair of cells per scene.
std::string row(const render::LightingPath& path, const std::vector<SceneResult>& scenes) {
  std::string html = fmt::format("<tr><th scope=\"row\">{}</th>", html_text(path.name));
  for (const SceneResult& scene : scenes) {
    const auto result = std::ranges::find(scene.paths, &path, &PathResult::path);
    html += fmt::format("<td>{:.2f}</td><td class=\"faint\">{}</td>", result->over_legacy,
                        error_text(result->largest_error));
  }
  return html + "</tr>\n";
}

}  // namespace

std::string SceneResult::drawn_file(const render::LightingPath& path) const {
  return fmt::format("{}-{}.png", name, path.name);
}

std::string SceneResult::error_file(const render::LightingPath& path) const {
  return fmt::format("{}-{}-error.png", name, path.name);
}

std::string SceneResult::reference_file(const render::LightingPath& path) const {
  if (&path == &render::lighting_paths().front()) return name + "-reference.png";
  return fmt::format("{}-{}-reference.png", name, path.name);
}

std::string SceneResult::sheet_file() const { return name + "-paths.png"; }

std::vector<std::string> picture_files(const std::string& scene) {
  const SceneResult result{.name = scene, .description = "", .conditions = "", .lights = 0};
  std::vector<std::string> files{result.sheet_file()};
  for (const render::LightingPath& path : render::lighting_paths()) {
    files.insert(files.end(), {result.drawn_file(path), result.error_file(path), result.reference_file(path)});
  }
  return files;
}

std::string comparison_page(const PageFacts& facts, const std::vector<SceneResult>& scenes) {
  std::string names;
  std::string columns;
  std::string sections;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    names += fmt::format("<th scope=\"colgroup\" colspan=\"2\"><a href=\"#scene-{}\">{}</a></th>", i,
                         html_text(scenes[i].name));
    columns += "<th scope=\"col\">&times; legacy</th><th scope=\"col\">largest error</th>";
    sections += section(scenes[i], i);
  }
  std::string rows;
  for (const render::LightingPath& path : render::lighting_paths()) rows += row(path, scenes);
  return filled("comparison.html", fmt::arg("style", page_text("comparison.css")), fmt::arg("width", facts.width),
                fmt::arg("height", facts.height), fmt::arg("machine", html_text(facts.machine)),
                fmt::arg("settings", html_text(facts.settings)), fmt::arg("frames", facts.frames),
                fmt::arg("names", names), fmt::arg("columns", columns), fmt::arg("rows", rows),
                fmt::arg("least", drawing::kHeatLeast), fmt::arg("gradient", heat_gradient()),
                fmt::arg("most", drawing::kHeatLeast * std::pow(10.0, drawing::kHeatDecades)),
                fmt::arg("sections", sections));
}

}  // namespace litfog::demo
