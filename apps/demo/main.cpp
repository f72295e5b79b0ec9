// SPDX-License-Identifier: Apache-2.0
// litfog-demo: draws lit-fog scenes without a display.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

#include "command/command.h"
#include "command/number.h"
#include "command/progress.h"
#include "command/whole_file.h"
#include "demo/gallery.h"
#include "demo/heat_map.h"
#include "demo/path_comparison.h"
#include "demo/picture_file.h"
#include "litfog/gl/headless_context.h"
#include "litfog/gl/unsupported.h"
#include "measure/comparison.h"
#include "measure/frame_times.h"
#include "render/renderer.h"
#include "scene/file/scene_file.h"

namespace {

using namespace litfog;
using namespace litfog::demo;
using namespace litfog::scene;
using namespace litfog::render;
using namespace litfog::measure;
using namespace litfog::command;

constexpr int kMaxSide = 16'384;
constexpr std::int64_t kMaxPixels = 40'000'000;  // some 2 GiB of framebuffer, 4 for paths of several passes

constexpr std::int64_t kMaxReferencePixels = 10'000'000;  // some 3 GiB of geometry buffer
constexpr std::int64_t kMaxComparedPixels = 2'500'000;    // some 3 GiB of ten framebuffers and a geometry buffer

constexpr NumberRule kSeconds{[](double x) { return x >= 0 && x <= kMaxSeconds; }, "must be a number in [0, 1e9]"};

enum class FogChoice { exp, exp2, none };
enum class FogLighting { peak };

template <typename Choice>
using Names = std::vector<std::pair<std::string, Choice>>;
const Names<FogChoice> kFogNames{{"exp", FogChoice::exp}, {"exp2", FogChoice::exp2}, {"none", FogChoice::none}};
const Names<FogLighting> kFogLightingNames{{"peak", FogLighting::peak}};

Names<const LightingPath*> path_names() {
  Names<const LightingPath*> names;
  for (const LightingPath& path : lighting_paths()) names.emplace_back(path.name, &path);
  return names;
}

template <typename Choice>
const std::string& name_of(const Names<Choice>& names, Choice choice) {
  return std::ranges::find(names, choice, &std::pair<std::string, Choice>::second)->first;
}

struct Options {
  std::vector<std::string> scenes;
  std::string output;
  std::string gallery;
  std::string compare;
  FogChoice fog = FogChoice::exp;
  double visibility = std::numeric_limits<double>::quiet_NaN();  // not given
  FogLighting fog_lighting = FogLighting::peak;
  int width = 1280;
  int height = 720;
  int frames = 0;  // not given
  double seconds = 0;
  RenderSettings render;
  bool reference = false;
  std::string heat_map;
  std::string stats;
  bool list_paths = false;
  bool list_scenes = false;
};

void parse_size(const std::string& text, Options& options) {
  const auto cross = text.find('x');
  const auto width = parse_integer(std::string_view(text).substr(0, cross));
  const auto height = cross == std::string::npos ? width : parse_integer(std::string_view(text).substr(cross + 1));
  const bool is_side = width && height && *width >= 1 && *height >= 1 && *width <= kMaxSide && *height <= kMaxSide;
  if (cross == std::string::npos || !is_side || std::int64_t(*width) * *height > kMaxPixels) {
    fail_option("--size", text,
                  fmt::format("must be WIDTHxHEIGHT, each in [1, {}], at most {} pixels in all", kMaxSide, kMaxPixels));
  }
  options.width = *width;
  options.height = *height;
}

/// A scene's file: a bundled scene by its name, else the path itself.
std::string scene_path(const std::string& scene) {
  const std::string bundled = bundled_scene_path(scene);
  std::error_code error;
  const bool is_name = std::filesystem::path(scene).filename() == scene;
  return is_name && std::filesystem::exists(bundled, error) ? bundled : scene;
}

FogMode fog_mode(FogChoice choice) { return choice == FogChoice::exp2 ? FogMode::exp2 : FogMode::exp; }

/// The visibility asked for, if any.
std::optional<double> chosen_visibility(const Options& options) {
  if (options.fog == FogChoice::none) return std::numeric_limits<double>::infinity();
  if (std::isnan(options.visibility)) return std::nullopt;
  return options.visibility;
}

/// Whether two paths, one of which need not be there yet, are one file.
bool is_same_file(const std::string& a, const std::string& b) {
  std::error_code error;
  const auto plain = [&error](const std::string& path) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(path, error), error);
  };
  return std::filesystem::equivalent(a, b, error) || plain(a) == plain(b);
}

bool needs_reference(const Options& options) {
  return options.reference || !options.heat_map.empty() || !options.compare.empty();
}

void expect_places(const Options& options, const std::string& output) {
  expect_writable(output);
  for (const auto& [option, path] : {std::pair{"--heat-map", &options.heat_map}, {"--stats", &options.stats}}) {
    if (path->empty()) continue;
    if (is_same_file(output, *path)) fail_option(option, *path, "must not be the picture's file");
    expect_writable(*path);
  }
  if (!options.heat_map.empty() && !options.stats.empty() && is_same_file(options.heat_map, options.stats)) {
    fail_option("--stats", options.stats, "must not be the heat map's file");
  }
}

ExitStatus draw_scene(const Options& options) {
  Scene scene = read_scene(scene_path(options.scenes.front()));
  turn_cookies(scene, options.seconds);
  const std::string output = options.output.empty() ? scene.name + ".png" : options.output;
  expect_places(options, output);
  const gl::HeadlessContext context;
  Renderer renderer(scene, options.width, options.height, options.render);
  const double visibility = chosen_visibility(options).value_or(suggested_visibility(scene));
  const Fog fog = Fog::from_visibility(fog_mode(options.fog), visibility);
  renderer.set_fog(fog);
  const int frames = options.frames > 0 ? options.frames : 1;
  command::Progress shown;
  const measure::Progress progress = [&](std::string_view step) { shown.show(step); };
  const FrameTimes times = time_frames({&renderer}, FrameBudget::exactly(frames), progress).front();
  std::optional<Comparison> comparison;
  if (needs_reference(options)) comparison = compare_with_reference(renderer, progress);
  if (!options.heat_map.empty()) {
    write_picture(options.heat_map,
                  make_heat_map(comparison->error, fmt::format("{}, {}", scene.name, options.render.path->name)));
  }
  write_picture(output, !comparison ? renderer.read() : options.reference ? comparison->reference : comparison->drawn);
  if (!options.stats.empty()) {
    nlohmann::ordered_json stats{
        {"scene", scene.name},
        {"path", options.render.path->name},
        {"fog_light", name_of(kFogLightingNames, options.fog_lighting)},
        {"fog", name_of(kFogNames, options.fog)},
        {"visibility_m", std::isinf(visibility) ? nlohmann::ordered_json("inf") : nlohmann::ordered_json(visibility)},
        {"size", {options.width, options.height}},
        {"lights", scene.lights.size()},
        {"frames", frames},
        {"ms_per_frame",
         {{"median", times.median()},
          {"spread", times.spread()},
          {"min", times.milliseconds.front()},
          {"max", times.milliseconds.back()}}},
        {"skip", options.render.skipping == Skipping::on},
        {"chunks_drawn", times.counts.chunks_drawn},
        {"chunks_skipped", times.counts.chunks_skipped},
        {"surface_lights_listed", times.counts.lights_listed},
        {"surface_lights_skipped", times.counts.lights_skipped},
        {"gl_renderer", context.renderer()},
        {"gl_version", context.version()}};
    if (comparison) {
      stats["max_error_255"] = comparison->error.largest;
      stats["mean_error_255"] = comparison->error.mean;
      stats["excepted_pixels"] = comparison->error.excluded;
    }
    constexpr auto kReplace = nlohmann::ordered_json::error_handler_t::replace;  // a file's name may be no UTF-8
    write_whole_file(options.stats, stats.dump(2, ' ', false, kReplace) + "\n");
  }
  write_standard_output(fmt::format("{}: {} ({}x{}) in {} ms on {}\n", output, scene.name, options.width,
                                    options.height, milliseconds_text(times.median()), context.renderer()));
  if (comparison) {
    write_standard_output(fmt::format("{}: {}\n", options.render.path->name, error_in_words(comparison->error)));
  }
  return kDone;
}

PathComparisonSettings path_comparison_settings(const Options& options) {
  PathComparisonSettings settings{.fog_mode = fog_mode(options.fog),
                                  .visibility = chosen_visibility(options),
                                  .seconds = options.seconds,
                                  .width = options.width,
                                  .height = options.height,
                                  .render = options.render};
  if (options.frames > 0) settings.frames = options.frames;
  return settings;
}

ExitStatus run(const Options& options) {
  if (options.list_paths) {
    for (const LightingPath& path : lighting_paths()) {
      write_standard_output(fmt::format("{:<12} {} ({})\n", path.name, path.description, path.source));
    }
    return kDone;
  }
  if (options.list_scenes) {
    for (const std::string& name : bundled_scenes()) {
      write_standard_output(fmt::format("{:<12} {}\n", name, read_scene(bundled_scene_path(name)).description));
    }
    return kDone;
  }
  try {
    if (options.gallery.empty() && options.compare.empty()) return draw_scene(options);
    std::vector<std::string> scenes = options.scenes.empty() ? bundled_scenes() : options.scenes;
    std::ranges::transform(scenes, scenes.begin(), scene_path);
    const gl::HeadlessContext context;
    write_standard_output(fmt::format("drawing {} scenes on {}\n", scenes.size(), context.renderer()));
    if (!options.compare.empty()) {
      compare_paths(scenes, options.compare, context.renderer(), path_comparison_settings(options));
      return kDone;
    }
    draw_gallery(scenes, options.gallery,
                 {.fog_mode = fog_mode(options.fog),
                  .width = options.width,
                  .height = options.height,
                  .render = options.render});
    return kDone;
  } catch (const gl::Unsupported& missing) {
    throw MissingCapability(missing.what());
  }
}

/// Options that would be passed over in silence, and values that only show as wrong beside others.
void refuse_what_does_not_fit(const CLI::App& app, const Options& options) {
  const auto is_given = [&app](const char* option) { return app.count(option) > 0; };
  for (const char* list : {"--list-paths", "--list-scenes"}) {
    if (is_given(list) && app.count_all() > 2) fail_option(list, "given", "must stand alone");
  }
  if (options.list_paths || options.list_scenes) return;
  for (const auto& [option, value] : {std::pair{"--output", &options.output},
                                      {"--heat-map", &options.heat_map},
                                      {"--stats", &options.stats},
                                      {"--gallery", &options.gallery},
                                      {"--compare", &options.compare}}) {
    if (is_given(option) && value->empty()) fail_option(option, "", "must not be empty");
  }
  if (options.gallery.empty() && options.compare.empty() && options.scenes.size() != 1) {
    fail_option("SCENE", std::to_string(options.scenes.size()) + " given",
                  "must be one, or use --gallery FOLDER or --compare FOLDER");
  }
  if (!options.compare.empty()) {  // which draws every scene by every path, and its reference
    for (const char* option :
         {"--gallery", "--output", "--reference", "--heat-map", "--stats", "--path", "--flat-shading"}) {
      if (is_given(option)) fail_option("--compare", options.compare, std::string("must stand without ") + option);
    }
  }
  if (!options.gallery.empty()) {  // which draws every scene once at each of its own visibilities
    for (const char* option :
         {"--output", "--reference", "--heat-map", "--stats", "--visibility", "--frames", "--time"}) {
      if (is_given(option)) fail_option("--gallery", options.gallery, std::string("must stand without ") + option);
    }
    if (options.fog == FogChoice::none) fail_option("--gallery", options.gallery, "must stand without --fog none");
  }
  if (options.fog == FogChoice::none && is_given("--visibility")) {
    fail_option("--fog", "none", "must stand without --visibility");
  }
  const LightingPath& path = *options.render.path;
  const auto refuse_beside_path = [&](const char* option, bool fits, const char* rule) {
    if (is_given(option) && !fits && options.compare.empty()) fail_option("--path", path.name, rule);
  };
  refuse_beside_path("--map-size", path.maps != LightMapSet::none, "must be one with light maps beside --map-size");
  refuse_beside_path("--flat-shading", path.evaluation == Evaluation::lookup && path.surface == SurfaceModel::diffuse,
                     "must be lookup-3d or lookup-2d beside --flat-shading");
  refuse_beside_path("--infinite-viewer", path.surface == SurfaceModel::basic,
                     "must be one with highlights beside --infinite-viewer");
  if (is_given("--output") && !is_picture_path(options.output)) {
    fail_option("--output", options.output, "must end in .png or .exr");
  }
  if (is_given("--heat-map") && std::filesystem::path(options.heat_map).extension() != ".png") {
    fail_option("--heat-map", options.heat_map, "must end in .png");
  }
  if (needs_reference(options) && options.render.is_flat_shaded) {
    fail_option("--flat-shading", "given", "must stand without --reference and --heat-map, which shade smoothly");
  }
  const std::int64_t most = options.compare.empty() ? kMaxReferencePixels : kMaxComparedPixels;
  if (needs_reference(options) && std::int64_t(options.width) * options.height > most) {
    fail_option("--size", fmt::format("{}x{}", options.width, options.height),
                  fmt::format("must be at most {} pixels in all {}", most,
                              options.compare.empty() ? "for a reference" : "beside --compare"));
  }
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app{"Draws a scene lit by lamps in fog, without a display (OpenGL 3.3 through EGL).", "litfog-demo"};
  app.add_option("SCENE", options.scenes,
                 "A scene of --list-scenes, a scene file or a glTF file; several with --gallery or --compare");
  app.add_option("-o,--output", options.output, "Picture to write: .png (sRGB) or .exr (linear); default SCENE.png")
      ->type_name("FILE");
  add_choice(app, "--fog", options.fog, kFogNames, "How fog thickens with range (default exp)");
  add_number(app, "--visibility", options.visibility, kNotNegative,
             "Metres at which 5 % contrast is left; inf is clear air (default: one that the scene suggests)");
  add_choice(app, "--path", options.render.path, path_names(), "Lighting path of --list-paths (default unified)");
  add_integer(app, "--map-size", options.render.map_size, 8, 256,
              "Texels a side of the paths' light maps (default 128)");
  app.add_flag("--flat-shading", options.render.is_flat_shaded,
               "lookup-3d and lookup-2d: the directional light by the faces' normals");
  app.add_flag("--infinite-viewer", options.render.has_infinite_viewer,
               "Highlights as seen from far away along the camera's axis");
  add_choice(app, "--fog-light", options.fog_lighting, kFogLightingNames,
             "How lights light the fog: carried lights by Hales's peak (default peak)");
  app.add_option_function<std::string>(
         "--size", [&](const std::string& text) { parse_size(text, options); }, "Pixels (default 1280x720)")
      ->type_name("WxH");
  add_number(app, "--time", options.seconds, kSeconds,
             "Seconds for which the scene's cookies have been spinning (default 0)");
  add_integer(app, "--frames", options.frames, 1, 100'000,
              "Frames to draw and time, after one that is not timed (default 1, with --compare 5 of each path)");
  app.add_flag_callback(
      "--no-skip", [&] { options.render.skipping = Skipping::off; },
      "Draw and light everything, even what cannot show");
  app.add_flag("--reference", options.reference,
               "Write the picture that the CPU shades in double by the path's plain formulas");
  app.add_option("--heat-map", options.heat_map, "Write the path's error against that picture as colours, .png")
      ->type_name("FILE");
  app.add_option("--stats", options.stats, "Write times and counts as JSON")->type_name("FILE");
  app.add_option("--gallery", options.gallery,
                 "Draw the scenes (default all) clear and at their visibilities, and a contact sheet, into a folder")
      ->type_name("FOLDER");
  app.add_option(
         "--compare", options.compare,
         "Draw the scenes (default all) by every lighting path, timed in turn, with heat maps, contact sheets and "
         "index.html, into a folder")
      ->type_name("FOLDER");
  app.add_flag("--list-paths", options.list_paths, "List the lighting paths");
  app.add_flag("--list-scenes", options.list_scenes, "List the scenes that come with litfog");
  app.footer(
      "Examples:\n"
      "  litfog-demo headlights --visibility 150 -o fog.png\n"
      "  litfog-demo approach --fog exp2 --visibility 800 --size 1920x1080 -o approach.exr\n"
      "  litfog-demo room --path vertex --heat-map error.png\n"
      "  litfog-demo --gallery out\n"
      "  litfog-demo --compare paths room headlights --size 960x540\n"
      "\n"
      "Exit status: 0 done, 1 wrong usage, 2 bad scene or light file, 3 no OpenGL 3.3 through EGL, 4 cannot write.");
  return run_command(app, argc, argv, [&] {
    refuse_what_does_not_fit(app, options);
    return run(options);
  });
}
