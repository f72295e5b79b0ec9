// SPDX-License-Identifier: Apache-2.0
#include "gallery.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <future>
#include <map>
#include <tuple>

#include "command.h"
#include "contact_sheet.h"
#include "exit_status.h"
#include "scene_file.h"
#include "table.h"

namespace litfog::demo {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// Shown at once: a gallery takes a while.
void report(const std::string& text) {
  write_standard_output(text);
  flush_standard_output();
}

/// Whether two lights have one row in the table: the name and all that the solution depends on are the same.
bool is_same_kind(const Light& a, const Light& b) {
  const auto row = [](const Light& light) {
    const Attenuation& attenuation = light.attenuation;
    return std::tie(light.name, attenuation.constant, attenuation.linear, attenuation.quadratic, light.threshold,
                    light.density_scale);
  };
  return row(a) == row(b);
}

/// Extent, peak range and intensity of each kind of light in a scene at each visibility.
void add_solutions(Table& table, const Scene& scene, FogMode mode) {
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

}  // namespace

void draw_gallery(const std::vector<std::string>& scenes, const std::string& folder, const GallerySettings& settings) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw CannotWrite(folder + ": cannot be made: " + error.message());
  const auto path_of = [&](const std::string& name) { return (std::filesystem::path(folder) / name).string(); };
  const Clock::time_point start = Clock::now();
  Table solutions{{"scene", "light", "visibility_m", "extent_m", "peak_range_m", "intensity"}, {}};
  std::vector<std::vector<SheetEntry>> sheet;
  std::map<std::string, std::string> files;  // by their scenes' names
  std::future<void> writing;                 // a picture is encoded while the next one is drawn
  for (const std::string& name : scenes) {
    const Clock::time_point scene_start = Clock::now();
    const Scene scene = read_scene(name);
    const auto [earlier, is_new] = files.try_emplace(scene.name, name);
    if (!is_new) {
      throw BadInput(fmt::format("{}: name = {}: must not be that of {} too", name, scene.name, earlier->second));
    }
    Renderer renderer(scene, settings.width, settings.height, settings.render);
    report(fmt::format("{}: {} lights, loaded in {:.2f} s\n", scene.name, scene.lights.size(),
                       seconds_since(scene_start)));
    add_solutions(solutions, scene, settings.fog_mode);
    std::vector<double> visibilities{std::numeric_limits<double>::infinity()};
    visibilities.insert(visibilities.end(), scene.visibilities.begin(), scene.visibilities.end());
    sheet.emplace_back();
    for (const double visibility : visibilities) {
      const bool is_clear = std::isinf(visibility);
      const std::string label = is_clear ? "clear" : fmt::format("{}m", visibility);
      const std::string path = path_of(scene.name + "-" + label + ".png");
      const Clock::time_point frame_start = Clock::now();
      renderer.set_fog(Fog::from_visibility(settings.fog_mode, visibility));
      renderer.draw();
      Picture picture = renderer.read();
      const double draw_seconds = seconds_since(frame_start);
      const std::string caption =
          is_clear ? scene.name + ", clear air" : fmt::format("{}, visibility {} m", scene.name, visibility);
      sheet.back().push_back({reduced(picture, kSheetCellWidth), caption});
      if (writing.valid()) writing.get();
      writing = std::async(std::launch::async, [path, drawn = std::move(picture)] { write_picture(path, drawn); });
      report(fmt::format("  {:<40} drawn in {:.2f} s\n", path, draw_seconds));
    }
  }
  if (writing.valid()) writing.get();
  const std::string sheet_path = path_of("contact-sheet.png");
  write_picture(sheet_path, make_contact_sheet(sheet));
  write_standard_output("\n" + format_table(solutions, TableFormat::text));
  write_standard_output(fmt::format("\n{} shows all; {:.1f} s in all\n", sheet_path, seconds_since(start)));
}

}  // namespace litfog::demo
