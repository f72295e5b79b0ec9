// SPDX-License-Identifier: Apache-2.0
#include "demo/compare/comparison.h"

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <utility>

#include "command/progress.h"
#include "command/standard_output.h"
#include "demo/compare/pages.h"
#include "drawing/contact_sheet.h"
#include "drawing/drawing.h"
#include "drawing/heat_map.h"
#include "drawing/picture_folder.h"
#include "files/whole_file.h"
#include "measure/frame_times.h"
#include "measure/picture_error.h"
#include "scene/scene.h"

namespace litfog::demo {
namespace {

constexpr std::size_t kSheetColumns = 4;

std::string words_of(const Fog& fog, double visibility) {
  if (std::isinf(visibility)) return "clear air";
  return fmt::format("{} fog, visibility {} m", name_of(fog.mode), visibility);
}

std::string words_of(const render::RenderSettings& settings) {
  std::string words = settings.skipping == render::Skipping::on ? "what is invisible is skipped" : "nothing is skipped";
  if (settings.papers.has_infinite_viewer) words += ", highlights as seen from far away";
  return fmt::format("{}, light maps of {} texels a side", words, settings.papers.map_size);
}

/// Pictures in reading order, as rows of a sheet.
class Sheet {
 public:
  void add(const render::Picture& picture, std::vector<std::string> caption) {
    if (rows_.empty() || rows_.back().size() == kSheetColumns) rows_.emplace_back();
    rows_.back().push_back({drawing::fitted_to_cell(picture), std::move(caption)});
  }
  render::Picture picture() const { return drawing::make_contact_sheet(rows_); }

 private:
  std::vector<std::vector<drawing::SheetEntry>> rows_;
};

std::vector<std::unique_ptr<render::Renderer>> make_renderers(const scene::Scene& scene, const Atmosphere& atmosphere,
                                                              const drawing::DrawingOptions& options) {
  std::vector<std::unique_ptr<render::Renderer>> renderers;
  for (const render::LightingPath& path : render::lighting_paths()) {
    renderers.push_back(
        std::make_unique<render::Renderer>(scene, options.width, options.height, options.settings_of(path)));
    renderers.back()->set_atmosphere(atmosphere);
  }
  return renderers;
}

/// The display of each path's picture. Chooses an automatic exposure by the first path's picture and sets it in all
/// renderers.
std::vector<drawing::Display> set_exposures(const std::vector<std::unique_ptr<render::Renderer>>& renderers,
                                            const scene::Scene& scene, const drawing::DisplayOptions& options) {
  std::vector<drawing::Display> displays;
  for (const auto& renderer : renderers) {
    displays.push_back(options.display_for(scene, renderer->settings().fog_lighting));
    render::Exposure& first = displays.front().exposure;
    if (displays.size() == 1) first = renderer->set_exposure(first);
    displays.back().exposure = first;
    renderer->set_exposure({.ev = first.ev});
  }
  return displays;
}

PathResult result_of(const render::LightingPath& path, const measure::FrameTimes& times,
                     const measure::FrameTimes& legacy, const measure::PictureError& error) {
  return {.path = &path,
          .milliseconds = times.median(),
          .spread = times.spread(),
          .over_legacy = times.median() / legacy.median(),
          .largest_error = error.largest,
          .mean_error = error.mean,
          .excluded = error.excluded};
}

/// Reports a path's result, writes its pictures and adds its picture to the scene's sheet.
///
/// reference, drawn  as a display shows them
void show_path(const SceneResult& scene, const PathResult& result, const measure::PictureError& picture_error,
               const render::Picture& reference, render::Picture drawn, drawing::PictureFolder& pictures,
               Sheet& sheet) {
  const render::LightingPath& path = *result.path;
  const std::string time = fmt::format("{} ms a frame, {:.2f} x legacy",
                                       measure::milliseconds_text(result.milliseconds), result.over_legacy);
  const std::string error = measure::error_in_words(picture_error);
  command::report(fmt::format("  {:<12} {:>32}; {}\n", path.name, time, error));
  sheet.add(drawn, {fmt::format("{}: {}", path.name, time), error});
  pictures.write(scene.error_file(path),
                 drawing::make_heat_map(picture_error, fmt::format("{}, {}", scene.name, path.name)));
  pictures.write(scene.drawn_file(path), std::move(drawn));
  pictures.write(scene.reference_file(path), reference);
}

SceneResult compare_scene(const scene::Scene& scene, drawing::PictureFolder& pictures, const std::string& machine,
                          const drawing::DrawingOptions& options, int frames) {
  const double visibility = options.visibility_in(scene);
  const Atmosphere atmosphere = options.atmosphere_of(scene, visibility);
  SceneResult result{.name = scene.name,
                     .description = scene.description,
                     .conditions = words_of(atmosphere.fog, visibility),
                     .lights = scene.lights.size()};
  command::report(fmt::format("{}: {} lights, {}\n", scene.name, scene.lights.size(), result.conditions));
  command::Progress shown;
  const measure::Progress progress = [&](std::string_view step) {
    shown.show(fmt::format("{}: {}", scene.name, step));
  };
  progress(measure::kCompiling);
  auto renderers = make_renderers(scene, atmosphere, options);
  const std::vector<drawing::Display> displays = set_exposures(renderers, scene, options.display);
  if (const std::string words = drawing::display_in_words(displays.front()); !words.empty())
    result.conditions += ", " + words;
  pictures.finish();  // encoding in the background would slow the frames
  const std::vector<measure::FrameTimes> times =
      measure::time_frames(renderers, measure::FrameBudget::exactly(frames), progress);
  const auto paths = render::lighting_paths();
  const auto legacy = std::size_t(render::find_lighting_path("legacy") - paths.data());
  Sheet sheet;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const measure::Comparison comparison = measure::compare_with_reference(*renderers[i], progress);
    const render::Picture drawn = drawing::whole_light(*renderers[i], comparison.drawn);
    renderers[i].reset();
    const render::Picture reference = drawing::displayed(comparison.reference, scene.camera, displays[i]);
    if (i == 0) {
      sheet.add(reference, {fmt::format("{}, {}: reference in double", scene.name, result.conditions),
                            fmt::format("{} x {} on {}", options.width, options.height, machine)});
    }
    result.paths.push_back(result_of(paths[i], times[i], times[legacy], comparison.error));
    show_path(result, result.paths.back(), comparison.error, reference,
              drawing::displayed(drawn, scene.camera, displays[i]), pictures, sheet);
  }
  pictures.write(result.sheet_file(), sheet.picture());
  return result;
}

constexpr const char* kPageFile = "index.html";

drawing::PictureFolder make_folder(const std::string& path, const std::vector<scene::Scene>& scenes) {
  std::vector<std::string> files{kPageFile};
  std::vector<std::string> inputs;
  for (const scene::Scene& scene : scenes) {
    const std::vector<std::string> pictures = picture_files(scene.name);
    files.insert(files.end(), pictures.begin(), pictures.end());
    inputs.insert(inputs.end(), scene.files.begin(), scene.files.end());
  }
  return {path, files, inputs};
}

}  // namespace

void compare_paths(const std::vector<scene::Scene>& scenes, const std::string& folder, const std::string& machine,
                   const drawing::DrawingOptions& options, int frames) {
  drawing::PictureFolder pictures = make_folder(folder, scenes);
  const std::string page = pictures.path_of(kPageFile);
  std::vector<SceneResult> results;
  for (const scene::Scene& scene : scenes) results.push_back(compare_scene(scene, pictures, machine, options, frames));
  pictures.finish();
  files::write_whole_file(page, comparison_page({.machine = machine,
                                                 .width = options.width,
                                                 .height = options.height,
                                                 .frames = frames,
                                                 .settings = words_of(options.render)},
                                                results));
  command::report(fmt::format("{} shows all\n", page));
}

}  // namespace litfog::demo
