// SPDX-License-Identifier: Apache-2.0
#include "demo/comparison_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "demo/heat_map.h"
#include "demo/html_text.h"
#include "measure/frame_times.h"
#include "scene/texels.h"

namespace litfog::demo {
namespace {

/// The radio buttons above the figures choose which of the pictures that lie on each other is seen; one that is held
/// shows its reference, and a reference what was drawn.
constexpr const char* kStyle = R"(
:root { color-scheme: dark; --ground: #101113; --panel: #191a1d; --line: #2b2d31; --ink: #dcdad4; --faint: #98968f;
  --accent: #f0b95b; }
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 120rem; padding: 0 1.25rem 3rem; background: var(--ground); color: var(--ink);
  font: 0.9375rem/1.45 "DejaVu Sans", Verdana, system-ui, sans-serif; }
h1 { font-size: 1.6rem; margin: 1.5rem 0 0.25rem; }
h2 { font-size: 1.3rem; margin: 0 0 0.15rem; }
h3 { font-size: 1rem; margin: 0; color: var(--accent); }
p { margin: 0.15rem 0; max-width: 60rem; }
a { color: inherit; text-underline-offset: 0.2em; text-decoration-color: var(--faint); }
a:hover { color: var(--accent); }
.faint, .source, dt, th { color: var(--faint); font-weight: normal; }
section { margin-top: 2.5rem; scroll-margin-top: 4rem; }
.views { position: fixed; opacity: 0; }
nav { position: sticky; top: 0; z-index: 1; display: flex; flex-wrap: wrap; gap: 0.5rem 1.25rem; align-items: center;
  margin: 1rem -1.25rem 0; padding: 0.6rem 1.25rem; background: var(--ground); border-bottom: 1px solid var(--line); }
nav .choice { display: inline-flex; border: 1px solid var(--line); border-radius: 0.4rem; overflow: hidden; }
nav label { padding: 0.25rem 0.9rem; cursor: pointer; background: var(--panel); color: var(--faint); }
nav label + label { border-left: 1px solid var(--line); }
#drawn:checked ~ nav [for="drawn"], #error:checked ~ nav [for="error"],
#reference:checked ~ nav [for="reference"] { background: var(--accent); color: var(--ground); }
.views:focus-visible ~ nav .choice { outline: 2px solid var(--ink); outline-offset: 2px; }
nav .hint { color: var(--faint); }
nav .scale { display: none; gap: 0.5rem; align-items: center; font-size: 0.8125rem; }
#error:checked ~ nav .scale { display: inline-flex; }
nav .colors { width: 11rem; height: 0.8rem; border: 1px solid var(--line); }
.table { overflow-x: auto; margin-top: 1rem; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; }
th, td { padding: 0.2rem 0.25rem 0.2rem 1.75rem; text-align: right; white-space: nowrap; }
th[scope="row"] { color: var(--ink); padding-left: 0; text-align: left; }
th[scope="col"] { font-size: 0.75rem; }
td:nth-child(odd), th[scope="col"]:nth-child(odd) { padding-left: 0.9rem; }
tbody tr { border-top: 1px solid var(--line); }
.grid { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 23rem), 1fr)); gap: 1rem;
  margin-top: 0.9rem; }
figure { margin: 0; display: flex; flex-direction: column; background: var(--panel); border: 1px solid var(--line);
  border-radius: 0.4rem; overflow: hidden; }
figcaption { display: flex; flex-direction: column; flex: 1; padding: 0.6rem 0.8rem 0.7rem; font-size: 0.875rem; }
.picture { position: relative; aspect-ratio: var(--shape); background: #000; }
.picture img { position: absolute; inset: 0; width: 100%; height: 100%; object-fit: cover; object-position: top;
  user-select: none; -webkit-touch-callout: none; }
.picture .error, .picture .reference { visibility: hidden; }
#error:checked ~ main .error, #reference:checked ~ main .reference, .picture:active .reference { visibility: visible; }
#reference:checked ~ main .picture:active .reference { visibility: hidden; }
dl { display: grid; grid-template-columns: repeat(4, auto); justify-content: space-between; gap: 0 0.75rem;
  margin: auto 0 0.35rem; padding-top: 0.5rem; }
dt { font-size: 0.75rem; }
dd { margin: 0; font-size: 1.0625rem; font-variant-numeric: tabular-nums; }
.files { font-size: 0.8125rem; color: var(--faint); }
p + .files { margin-top: auto; padding-top: 0.5rem; }
)";

std::string error_text(double error) { return fmt::format("{:.3g}", error); }

/// The heat map's colours as the stops of a gradient.
std::string heat_gradient() {
  constexpr int kSteps = 24;
  std::string stops;
  for (int i = 0; i <= kSteps; ++i) {
    const glm::vec3 color = heat_color(double(i) / kSteps);
    stops += fmt::format(", #{:02x}{:02x}{:02x}", scene::srgb_level_of(color.r), scene::srgb_level_of(color.g),
                         scene::srgb_level_of(color.b));
  }
  return "linear-gradient(to right" + stops + ")";
}

std::string image(std::string_view kind, const std::string& file, const std::string& alternative) {
  return fmt::format(R"(<img class="{}" src="{}" alt="{}" loading="lazy" draggable="false">)"
                     "\n",
                     kind, html_link(file), html_text(alternative));
}

std::string link(const std::string& file, std::string_view words) {
  return fmt::format(R"(<a href="{}">{}</a>)", html_link(file), words);
}

std::string value(std::string_view term, const std::string& description) {
  return fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", term, description);
}

std::string reference_figure(const SceneResult& scene) {
  const render::LightingPath& path = *scene.paths.front().path;
  const std::string file = scene.reference_file(path);
  return "<figure>\n<div class=\"picture\">\n" +
         image("only", file, fmt::format("{}: the reference of {}", scene.name, path.name)) +
         fmt::format(
             "</div>\n<figcaption>\n<h3>Reference</h3>\n"
             "<p class=\"source\">on the CPU, in double</p>\n"
             "<p>every light on every sample by the plain formulas, here those of {}; the other paths' differ, and "
             "each path's error is against its own</p>\n<p class=\"files\">{}</p>\n</figcaption>\n</figure>\n",
             path.name, link(file, "picture"));
}

std::string figure(const SceneResult& scene, const PathResult& result) {
  const render::LightingPath& path = *result.path;
  const std::string title = fmt::format("{}, {}", scene.name, path.name);
  std::string html = "<figure>\n<div class=\"picture\">\n";
  html += image("drawn", scene.drawn_file(path), title + ": the picture");
  html += image("error", scene.error_file(path),
                fmt::format("{}: the error, largest {} and mean {} of 1/255", title, error_text(result.largest_error),
                            error_text(result.mean_error)));
  html += image("reference", scene.reference_file(path), title + ": the path's own reference");
  html += fmt::format("</div>\n<figcaption>\n<h3>{}</h3>\n<p class=\"source\">{}</p>\n<p>{}</p>\n<dl>\n",
                      html_text(path.name), html_text(path.source), html_text(path.description));
  html += value("ms a frame", fmt::format(R"(<span title="10th to 90th percentile: {} ms">{}</span>)",
                                          measure::milliseconds_text(result.spread),
                                          measure::milliseconds_text(result.milliseconds)));
  html += value("&times; legacy", fmt::format("{:.2f}", result.over_legacy));
  html += value("largest error", error_text(result.largest_error));
  html += value("mean error", error_text(result.mean_error));
  html += fmt::format("</dl>\n<p class=\"files\">{} &middot; {} &middot; {}", link(scene.drawn_file(path), "picture"),
                      link(scene.error_file(path), "error"), link(scene.reference_file(path), "reference"));
  if (result.excluded > 0) html += fmt::format(" &middot; pixels excluded: {}", result.excluded);
  return html + "</p>\n</figcaption>\n</figure>\n";
}

std::string section(const SceneResult& scene, std::size_t number) {
  std::string html = fmt::format(
      "<section id=\"scene-{}\">\n<h2>{}</h2>\n<p>{}</p>\n"
      "<p class=\"faint\">{}; lights: {}; {}</p>\n<div class=\"grid\">\n",
      number, html_text(scene.name), html_text(scene.description), html_text(scene.conditions), scene.lights,
      link(scene.sheet_file(), "all in one picture"));
  html += reference_figure(scene);
  for (const PathResult& result : scene.paths) html += figure(scene, result);
  return html + "</div>\n</section>\n";
}

/// Paths down, scenes across.
std::string table(const std::vector<SceneResult>& scenes) {
  std::string names;
  std::string columns;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    names += fmt::format("<th scope=\"colgroup\" colspan=\"2\"><a href=\"#scene-{}\">{}</a></th>", i,
                         html_text(scenes[i].name));
    columns += "<th scope=\"col\">&times; legacy</th><th scope=\"col\">largest error</th>";
  }
  std::string html = fmt::format(
      "<div class=\"table\">\n<table>\n<thead>\n<tr><td></td>{}</tr>\n<tr><td></td>{}</tr>\n</thead>\n<tbody>\n", names,
      columns);
  for (const render::LightingPath& path : render::lighting_paths()) {
    html += fmt::format("<tr><th scope=\"row\">{}</th>", html_text(path.name));
    for (const SceneResult& scene : scenes) {
      const auto result = std::ranges::find(scene.paths, &path, &PathResult::path);
      html += fmt::format("<td>{:.2f}</td><td class=\"faint\">{}</td>", result->over_legacy,
                          error_text(result->largest_error));
    }
    html += "</tr>\n";
  }
  return html + "</tbody>\n</table>\n</div>\n";
}

std::string navigation() {
  std::string html;
  std::string labels;
  for (const auto& [view, words] : {std::pair{"drawn", "Drawn"}, {"error", "Error"}, {"reference", "Reference"}}) {
    const bool is_first = html.empty();
    html += fmt::format("<input class=\"views\" type=\"radio\" name=\"view\" id=\"{}\"{}>\n", view,
                        is_first ? " checked" : "");
    labels += fmt::format("<label for=\"{}\">{}</label>", view, words);
  }
  return html + fmt::format(
                    "<nav aria-label=\"What the figures show\">\n<span class=\"choice\">{}</span>\n"
                    "<span class=\"hint\">Hold a picture to flip between drawn and reference.</span>\n"
                    "<span class=\"scale\">{:g} <span class=\"colors\" style=\"background: {}\"></span> {:g} of 1/255, "
                    "logarithmic; red is "
                    "excluded</span>\n</nav>\n",
                    labels, kHeatLeast, heat_gradient(), kHeatLeast * std::pow(10.0, kHeatDecades));
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

std::string comparison_page(const PageFacts& facts, const std::vector<SceneResult>& scenes) {
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>litfog: lighting paths compared</title>\n<style>{}.picture {{ --shape: {} / {}; "
      "}}\n</style>\n</head>\n<body>\n"
      "<h1>Lighting paths compared</h1>\n"
      "<p>Drawn by litfog on {}, {} &times; {} pixels; {}. Times are medians of {} frames of each path, drawn in turn. "
      "Errors are in 1/255 of what a display shows, against the path&rsquo;s own formulas in double.</p>\n",
      kStyle, facts.width, facts.height, html_text(facts.machine), facts.width, facts.height, html_text(facts.settings),
      facts.frames);
  html += table(scenes);
  html += navigation();
  html += "<main>\n";
  for (std::size_t i = 0; i < scenes.size(); ++i) html += section(scenes[i], i);
  return html + "</main>\n</body>\n</html>\n";
}

}  // namespace litfog::demo
