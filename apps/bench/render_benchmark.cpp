// SPDX-License-Identifier: Apache-2.0
#include "bench/benchmarks.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/glm.hpp>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "bench/light_count.h"
#include "bench/plain_renderer.h"
#include "command/progress.h"
#include "litfog/gl/headless_context.h"
#include "measure/frame_times.h"
#include "measure/picture_error.h"
#include "scene/file/scene_file.h"

namespace litfog::bench {
namespace {

/// The conditions under which all paths' frames are drawn.
struct Setting {
  std::string scene;
  std::size_t lights;
  int width;
  int height;
  render::Skipping skipping;
  int samples = 4;
  bool has_all_paths = true;  ///< else the default path, legacy and plain, and airlight if all else is at defaults
};

/// A path and its fog lighting, or the rival, PlainRenderer.
struct Technique {
  const render::LightingPath* path;  ///< null: the rival
  render::FogLighting fog_lighting;

  std::string path_name() const { return path ? std::string(path->name) : "plain"; }
  std::string name() const {
    return fmt::format("{}{}", path_name(), fog_lighting == render::FogLighting::airlight ? ", airlight" : "");
  }
  friend bool operator==(const Technique&, const Technique&) = default;
};

/// A technique's frames in a setting.
struct Trial {
  Setting setting;
  Technique technique;
  measure::FrameTimes times;
  double over_legacy;                     // ratio of medians
  double over_two_light_legacy;           // ratio of medians
  std::optional<double> over_plain = {};  // ratio of medians; none if plain cannot hold the lights
  /// Error of a smaller picture; none for the unlit pass and plain, which have no formulas.
  std::optional<measure::PictureError> error = {};
};

constexpr const char* kTableScene = "headlights";  // like Hales's figure 1
constexpr int kTableWidth = 640;
constexpr int kTableHeight = 360;

/// Sizes of the pictures whose errors are found. They are small, because the reference shades each sample in double and
/// integrates the airlight of each lamp to 1e-10.
constexpr glm::ivec2 kErrorSize{80, 45};
constexpr glm::ivec2 kAirlightErrorSize{32, 18};

std::vector<Setting> settings(bool quick) {
  if (quick) {
    return {{"room", 2, 80, 45, render::Skipping::on}, {"room", 16, 80, 45, render::Skipping::on}};
  }
  std::vector<Setting> all;
  for (const std::size_t lights : {1u, 2u, 4u, 16u, 64u, 256u}) {
    all.push_back({kTableScene, lights, kTableWidth, kTableHeight, render::Skipping::on});
    // With more lights, paths of several passes would take minutes a frame.
    if (lights <= 16) all.push_back({kTableScene, lights, kTableWidth, kTableHeight, render::Skipping::off});
  }
  for (const std::string& scene : scene::bundled_scenes()) {
    for (const std::size_t lights : {2u, 16u}) {
      for (const auto skipping : {render::Skipping::off, render::Skipping::on}) {
        for (const int samples : {1, 4}) {
          const bool has_all_paths =
              scene == kTableScene && lights == 2 && skipping == render::Skipping::on && samples == 4;
          all.push_back({scene, lights, 1280, 720, skipping, samples, has_all_paths});
        }
      }
    }
  }
  return all;
}

const render::LightingPath& default_path() { return render::lighting_paths().front(); }

constexpr Technique kPlain{nullptr, render::FogLighting::peak};

Technique legacy() { return {render::find_lighting_path("legacy"), render::FogLighting::peak}; }

/// Every path with the papers' fog, the default one with airlight, and plain.
std::vector<Technique> measured_techniques() {
  std::vector<Technique> techniques{
      {&render::unlit_path(), render::FogLighting::peak}, {&default_path(), render::FogLighting::airlight}, kPlain};
  for (const render::LightingPath& path : render::lighting_paths()) {
    techniques.push_back({&path, render::FogLighting::peak});
  }
  return techniques;
}

/// The techniques that a setting draws.
std::vector<Technique> techniques_of(const Setting& setting) {
  std::vector<Technique> techniques{{&default_path(), render::FogLighting::peak}, legacy(), kPlain};
  const bool is_as_by_default = setting.skipping == render::Skipping::on && setting.samples == 4;
  if (is_as_by_default) techniques.push_back({&default_path(), render::FogLighting::airlight});
  if (setting.has_all_paths) techniques = measured_techniques();
  if (setting.lights > kMaxPlainLights) std::erase(techniques, kPlain);
  return techniques;
}

/// Measures the techniques and two-light legacy, with interleaved frames.
std::vector<Trial> measure(const Setting& setting, const measure::FrameBudget& budget,
                           const measure::Progress& progress) {
  const scene::Scene bundled = scene::read_scene(scene::bundled_scene_path(setting.scene));
  const scene::Scene scene = with_light_count(bundled, setting.lights);
  const scene::Scene two_lights = with_light_count(bundled, 2);
  const Atmosphere atmosphere =
      scene.atmosphere.with(Fog::from_visibility(FogMode::exp, scene::suggested_visibility(scene)));
  std::vector<std::unique_ptr<render::Renderer>> renderers;  // null: plain
  std::unique_ptr<PlainRenderer> plain;
  std::vector<measure::DrawFrame> in_turn;
  const auto add = [&](const scene::Scene& drawn, const Technique& technique) {
    std::unique_ptr<render::Renderer>& renderer = renderers.emplace_back();
    if (technique == kPlain) {
      plain = std::make_unique<PlainRenderer>(drawn, setting.width, setting.height, setting.samples);
      plain->set_atmosphere(atmosphere);
      in_turn.push_back([&plain] {
        plain->draw();
        return render::FrameCounts{};
      });
      return;
    }
    const render::RenderSettings settings{.skipping = setting.skipping,
                                          .path = technique.path,
                                          .fog_lighting = technique.fog_lighting,
                                          .samples = setting.samples};
    renderer = std::make_unique<render::Renderer>(drawn, setting.width, setting.height, settings);
    renderer->set_atmosphere(atmosphere);
    in_turn.push_back(measure::frames_of(*renderer));
  };
  const std::vector<Technique> techniques = techniques_of(setting);
  for (const Technique& technique : techniques) add(scene, technique);
  if (setting.lights != 2) add(two_lights, legacy());
  const std::vector<measure::FrameTimes> times = measure::time_frames(in_turn, budget, progress);
  const auto time_of = [&](const Technique& technique) -> std::optional<double> {
    const auto found = std::ranges::find(techniques, technique);
    if (found == techniques.end()) return std::nullopt;
    return times[std::size_t(found - techniques.begin())].median();
  };
  const double legacy_time = *time_of(legacy());
  const double two_light_time = setting.lights == 2 ? legacy_time : times.back().median();
  const std::optional<double> plain_time = time_of(kPlain);
  std::vector<Trial> trials;
  for (std::size_t i = 0; i < techniques.size(); ++i) {
    const double time = times[i].median();
    trials.push_back({.setting = setting,
                      .technique = techniques[i],
                      .times = times[i],
                      .over_legacy = time / legacy_time,
                      .over_two_light_legacy = time / two_light_time});
    if (plain_time) trials.back().over_plain = time / *plain_time;
    if (renderers[i] && techniques[i].path != &render::unlit_path()) {
      const bool has_airlight = techniques[i].fog_lighting == render::FogLighting::airlight;
      const glm::ivec2 size = has_airlight ? kAirlightErrorSize : kErrorSize;
      renderers[i]->set_size(size.x, size.y);
      trials.back().error = measure::compare_with_reference(*renderers[i], progress).error;
      trials.back().error->pixels.clear();  // unused
    }
    renderers[i].reset();
  }
  return trials;
}

/// Whether a trial has the scene and size of the first one, which the picture shows.
bool is_shown(const Trial& trial, const std::vector<Trial>& trials) {
  const Setting& shown = trials.front().setting;
  return trial.setting.scene == shown.scene && trial.setting.width == shown.width;
}

command::Table make_table(const std::vector<Trial>& trials) {
  command::Table table{{"scene", "path", "fog_light", "lights", "size", "samples", "skip", "ms_per_frame", "ms_spread",
                        "ratio_to_legacy", "ratio_to_two_light_legacy", "ratio_to_plain", "max_error_255",
                        "mean_error_255", "excepted_pixels"},
                       {}};
  for (const Trial& trial : trials) {
    const Setting& setting = trial.setting;
    const auto of_error = [&](auto member) {
      return trial.error ? command::Table::Cell(double((*trial.error).*member))
                         : command::Table::Cell(std::monostate{});
    };
    table.rows.push_back(
        {setting.scene, trial.technique.path_name(), name_of(trial.technique.fog_lighting), double(setting.lights),
         fmt::format("{}x{}", setting.width, setting.height), double(setting.samples),
         setting.skipping == render::Skipping::on ? "on" : "off", trial.times.median(), trial.times.spread(),
         trial.over_legacy, trial.over_two_light_legacy,
         trial.over_plain ? command::Table::Cell(*trial.over_plain) : command::Table::Cell(std::monostate{}),
         of_error(&measure::PictureError::largest), of_error(&measure::PictureError::mean),
         of_error(&measure::PictureError::excluded)});
  }
  return table;
}

/// Frame time over the number of lights in the scene of table 1, one line per technique.
command::Chart make_light_chart(const std::vector<Trial>& trials, render::Skipping skipping) {
  command::Chart chart{
      .title = fmt::format("{}, {}", trials.front().setting.scene,
                           skipping == render::Skipping::on ? "what is invisible skipped" : "nothing skipped"),
      .x = {"lights", true},
      .y = {"wall time of a frame (ms)", true},
      .key = command::KeyPlace::beside};
  for (const Technique& technique : measured_techniques()) {
    command::Series series{.name = technique.name(), .style = command::SeriesStyle::line_and_points};
    for (const Trial& trial : trials) {
      const Setting& setting = trial.setting;
      const bool belongs = trial.technique == technique && setting.skipping == skipping && is_shown(trial, trials);
      if (belongs) series.points.push_back({double(setting.lights), trial.times.median()});
    }
    if (!series.points.empty()) chart.series.push_back(std::move(series));
  }
  return chart;
}

/// The cards of Steven Hales 2004, "Realtime Pixel Lighting Using Fragment Programs", table 1: "normalized graphics
/// card data", per pixel over legacy on the same card.
struct Card {
  const char* name;
  double legacy;
  double shader;
};
constexpr Card kCards[] = {{"ATI Radeon X800 PRO", 1.0, 1.95},
                           {"ATI Radeon 9800 PRO", 1.130, 2.450},
                           {"Nvidia GeForce FX 5950", 1.847, 4.830}};

/// Per pixel over legacy with two headlights: the paper's cards, then the paths here.
command::Chart make_table_1(const std::vector<Trial>& trials) {
  command::Chart chart{.title = "Hales 2004, table 1: two headlights, frame time over legacy",
                       .x = {"frame time over legacy", false, 0, 6},
                       .y = {"", false, 0, 0},
                       .key = command::KeyPlace::bottom_right};
  double row = 0;
  command::Series cards{.name = "2004, per pixel on all polygons", .style = command::SeriesStyle::points};
  for (const Card& card : kCards) cards.points.push_back({card.shader / card.legacy, row--, card.name});
  command::Series here[2] = {
      {.name = "this machine, nothing skipped", .style = command::SeriesStyle::points},
      {.name = "this machine, what is invisible skipped", .style = command::SeriesStyle::points}};
  double most = 3;
  for (const Technique& technique : measured_techniques()) {
    --row;
    for (const Trial& trial : trials) {
      const Setting& setting = trial.setting;
      if (trial.technique != technique || setting.lights != 2 || !is_shown(trial, trials)) continue;
      const double ratio = trial.over_legacy;
      most = std::max(most, ratio);
      const bool skips = setting.skipping == render::Skipping::on;
      here[skips].points.push_back({ratio, row, skips ? technique.name() : std::string{}});
    }
  }
  chart.x.most = std::ceil(most * 1.35);
  chart.y.least = row - 1;
  chart.y.most = 1;
  chart.series = {cards, here[0], here[1]};
  std::erase_if(chart.series, [](const command::Series& series) { return series.points.empty(); });
  return chart;
}

}  // namespace

Result measure_render(bool quick) {
  const gl::HeadlessContext context;
  std::vector<Trial> trials;
  const std::vector<Setting> all = settings(quick);
  const measure::FrameBudget budget =
      quick ? measure::FrameBudget::exactly(3) : measure::FrameBudget{.seconds = 5, .fewest = 3, .most = 25};
  command::Progress shown;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Setting& measured = all[i];
    const std::string setting =
        fmt::format("{} of {}: {}, {} {}, {}x{}, {} {} a pixel{}", i + 1, all.size(), measured.scene, measured.lights,
                    measured.lights == 1 ? "light" : "lights", measured.width, measured.height, measured.samples,
                    measured.samples == 1 ? "sample" : "samples",
                    measured.skipping == render::Skipping::off ? ", nothing skipped" : "");
    const measure::Progress progress = [&](std::string_view step) { shown.show(fmt::format("{}: {}", setting, step)); };
    std::ranges::move(measure(all[i], budget, progress), std::back_inserter(trials));
  }
  Result result;
  result.table = make_table(trials);
  result.gl_renderer = context.renderer();
  for (const Trial& trial : trials) {
    if (!trial.error) continue;
    // Unified is exact except for the rounding of floats and of the half-float framebuffer; all values are finite.
    const bool is_unified = trial.technique.path == &default_path();
    const double bound = is_unified ? 1 : std::numeric_limits<double>::max();
    if (trial.error->largest <= bound) continue;
    result.failures.push_back(fmt::format("{} of {} with {} lights: error = {}/255: must be {}", trial.technique.name(),
                                          trial.setting.scene, trial.setting.lights, trial.error->largest,
                                          is_unified ? fmt::format("at most {}/255", bound) : "finite"));
  }
  result.figure = {.title = fmt::format("Frames of every lighting path, {}x{}, {}", all.front().width,
                                        all.front().height, context.renderer()),
                   .charts = {make_table_1(trials), make_light_chart(trials, render::Skipping::on)},
                   .width = 2000,
                   .height = 700};
  command::Chart unskipped = make_light_chart(trials, render::Skipping::off);
  if (!unskipped.series.empty()) result.figure.charts.push_back(std::move(unskipped));
  result.figure.columns = int(result.figure.charts.size());
  return result;
}

}  // namespace litfog::bench
