// SPDX-License-Identifier: Apache-2.0
#include "demo/jobs.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <future>
#include <limits>
#include <mutex>
#include <thread>
#include <tuple>

#include "command/progress.h"
#include "command/standard_output.h"
#include "command/table.h"
#include "command/wall_timer.h"
#include "drawing/contact_sheet.h"
#include "drawing/drawing.h"
#include "drawing/picture_folder.h"
#include "litfog/gl/headless_context.h"
#include "scene/file/scene_file.h"

namespace litfog::demo {
namespace {

/// Whether two lights share a row of the table: same name, and same parameters of the solution.
bool is_same_kind(const Light& a, const Light& b) {
  const auto row = [](const Light& light) {
    const Attenuation& attenuation = light.attenuation;
    return std::tie(light.name, attenuation.constant, attenuation.linear, attenuation.quadratic, light.threshold,
                    light.density_scale);
  };
  return row(a) == row(b);
}

/// Extent, peak range and intensity of each different light in a scene at each visibility.
void add_solutions(command::Table& table, const scene::Scene& scene, FogMode mode) {
  std::vector<const Light*> kinds;
  for (const PlacedLight& placed : scene.lights) {
    const bool is_known =
        std::ranges::any_of(kinds, [&](const Light* kind) { return is_same_kind(*kind, placed.light); });
    if (!is_known) kinds.push_back(&placed.light);
  }
  for (const Light* kind : kinds) {
    for (const double visibility : scene.visibilities) {
      const FogIntensity solution = solve_fog_intensity(*kind, Fog::from_visibility(mode, visibility));
      table.rows.push_back(
          {scene.name, kind->name, visibility, solution.extent, solution.peak_range, solution.intensity});
    }
  }
}

constexpr const char* kSheetFile = "contact-sheet.png";

/// Infinity (clear air), then the scene's own visibilities.
std::vector<double> shown_visibilities(const scene::Scene& scene) {
  std::vector<double> visibilities{std::numeric_limits<double>::infinity()};
  visibilities.insert(visibilities.end(), scene.visibilities.begin(), scene.visibilities.end());
  return visibilities;
}

/// A scene drawn in one way at each visibility: a row of the sheet.
struct Row {
  const scene::Scene* scene;
  render::RenderSettings render;
  std::string title;   ///< in its captions
  std::string prefix;  ///< in its file names
};

/// A row per scene, and a second one for the first scene, drawn by peak, if airlight is the default.
std::vector<Row> make_rows(const std::vector<scene::Scene>& scenes, const drawing::DrawingOptions& options) {
  const render::RenderSettings settings = options.settings();
  std::vector<Row> rows;
  for (const scene::Scene& scene : scenes) {
    rows.push_back({&scene, settings, scene.name, scene.name});
    const bool compares_peak = !options.fog_light && settings.fog_lighting == render::FogLighting::airlight;
    if (!compares_peak || rows.size() > 1) continue;
    rows.push_back({&scene, settings, scene.name + " by --fog-light peak", scene.name + "-peak"});
    rows.back().render.fog_lighting = render::FogLighting::peak;
  }
  return rows;
}

std::string picture_file(const Row& row, double visibility) {
  return row.prefix + (std::isinf(visibility) ? "-clear" : fmt::format("-{}m", visibility)) + ".png";
}

drawing::DrawingOptions at_visibility(drawing::DrawingOptions options, double visibility) {
  options.visibility = visibility;
  return options;
}

drawing::PictureFolder make_folder(const std::string& path, const std::vector<Row>& rows) {
  std::vector<std::string> files{kSheetFile};
  std::vector<std::string> inputs;
  for (const Row& row : rows) {
    for (const double visibility : shown_visibilities(*row.scene)) files.push_back(picture_file(row, visibility));
    inputs.insert(inputs.end(), row.scene->files.begin(), row.scene->files.end());
  }
  return {path, files, inputs};
}

/// Shared by rows that are drawn at once.
struct Output {
  drawing::PictureFolder pictures;
  command::Progress& progress;
  std::size_t count;      ///< number of pictures
  std::size_t drawn = 0;  ///< number drawn so far
  std::mutex mutex = {};  ///< held while a picture is put into the folder and reported

  void show() { progress.show(fmt::format("{} of {} pictures drawn", drawn, count)); }
};

/// Draws a row's pictures on the current GL context.
std::vector<drawing::SheetEntry> draw_row(const Row& row, const drawing::DrawingOptions& options, Output& output) {
  {
    const std::lock_guard lock(output.mutex);
    command::report(
        fmt::format("{}: {} lights; the first picture compiles its shaders\n", row.title, row.scene->lights.size()));
  }
  render::Renderer renderer(*row.scene, options.width, options.height, row.render);
  std::vector<drawing::SheetEntry> entries;
  for (const double visibility : shown_visibilities(*row.scene)) {
    const std::string file = picture_file(row, visibility);
    const command::WallTimer timer;
    const drawing::Display display =
        drawing::set_fog_and_exposure(renderer, at_visibility(options, visibility)).display;
    renderer.draw();
    const render::Picture drawn = drawing::whole_light(renderer, renderer.read());
    const double seconds = timer.seconds();
    std::vector<std::string> caption{
        std::isinf(visibility) ? row.title + ", clear air" : fmt::format("{}, visibility {} m", row.title, visibility)};
    const std::string text = drawing::display_in_words(display);
    if (!text.empty()) caption.push_back(text);
    render::Picture picture = drawing::displayed(drawn, row.scene->camera, display);
    entries.push_back({drawing::fitted_to_cell(picture), std::move(caption)});
    const std::lock_guard lock(output.mutex);
    output.pictures.write(file, std::move(picture));
    ++output.drawn;
    output.show();
    command::report(fmt::format("  {:<40} drawn in {:.2f} s{}\n", output.pictures.path_of(file), seconds,
                                text.empty() ? "" : ", " + text));
  }
  return entries;
}

/// Draws rows, several at once: a driver compiles a context's shaders on one thread, which takes longer than drawing.
std::vector<std::vector<drawing::SheetEntry>> draw_rows(const std::vector<Row>& rows,
                                                        const drawing::DrawingOptions& options, Output& output) {
  constexpr unsigned kMaxThreads = 4;  // each has a scene in the driver's memory
  std::vector<std::vector<drawing::SheetEntry>> sheet(rows.size());
  std::atomic<std::size_t> next = 0;
  const auto draw_next_rows = [&] {
    try {
      const gl::HeadlessContext context;
      for (std::size_t i = next++; i < rows.size(); i = next++) sheet[i] = draw_row(rows[i], options, output);
    } catch (...) {
      next = rows.size();
      throw;
    }
  };
  std::vector<std::future<void>> threads;
  const std::size_t count = std::clamp(std::thread::hardware_concurrency(), 1u, kMaxThreads);
  for (std::size_t i = 0; i < std::min(count, rows.size()); ++i) {
    threads.push_back(std::async(std::launch::async, draw_next_rows));
  }
  for (std::future<void>& thread : threads) thread.get();
  return sheet;
}

}  // namespace

void draw_gallery(const std::vector<std::string>& scenes, bool are_all, const std::string& folder,
                  const drawing::DrawingOptions& options) {
  const command::WallTimer timer;
  command::Progress progress;
  progress.show("loading scenes");
  std::vector<scene::Scene> read = scene::read_scenes(scenes);
  if (are_all) std::erase_if(read, [](const scene::Scene& scene) { return scene.is_lit_at_vertices; });
  for (scene::Scene& scene : read) scene::move_to_time(scene, options.seconds);
  command::report(
      fmt::format("{} scene{} loaded in {:.2f} s\n", read.size(), read.size() == 1 ? "" : "s", timer.seconds()));
  const std::vector<Row> rows = make_rows(read, options);
  Output output{.pictures = make_folder(folder, rows), .progress = progress, .count = 0};
  for (const Row& row : rows) output.count += shown_visibilities(*row.scene).size();
  output.show();
  command::Table solutions{{"scene", "light", "visibility_m", "extent_m", "peak_range_m", "intensity"}, {}};
  for (const scene::Scene& scene : read) add_solutions(solutions, scene, options.fog_mode());
  const std::vector<std::vector<drawing::SheetEntry>> sheet = draw_rows(rows, options, output);
  drawing::PictureFolder& pictures = output.pictures;
  pictures.write(kSheetFile, drawing::make_contact_sheet(sheet));
  pictures.finish();
  command::report("\n" + command::format_table(solutions, command::TableFormat::text));
  command::report(fmt::format("\n{} shows all; {:.1f} s in all\n", pictures.path_of(kSheetFile), timer.seconds()));
}

}  // namespace litfog::demo
