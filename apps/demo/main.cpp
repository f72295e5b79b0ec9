// SPDX-License-Identifier: Apache-2.0
// litfog-demo: draws lit-fog scenes without a display.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "command/command.h"
#include "command/option_rule.h"
#include "command/output_files.h"
#include "command/progress.h"
#include "command/table.h"
#include "command/uncaught.h"
#include "command/wall_timer.h"
#include "demo/compare/comparison.h"
#include "demo/jobs.h"
#include "demo/sequence/animation.h"
#include "demo/sequence/sequence.h"
#include "drawing/drawing.h"
#include "drawing/drawing_options.h"
#include "drawing/heat_map.h"
#include "drawing/picture_file.h"
#include "drawing/picture_options.h"
#include "drawing/scene_options.h"
#include "files/whole_file.h"
#include "litfog/gl/headless_context.h"
#include "litfog/gl/unsupported.h"
#include "papers/paper_sheets.h"
#include "render/surface/polygon_sort.h"
#include "scene/file/scene_file.h"

namespace {

using namespace litfog;
using namespace litfog::command;
using namespace litfog::demo;

constexpr std::int64_t kMaxReferencePixels = 10'000'000;  // about 5 GiB, 3 of them geometry buffer
constexpr std::int64_t kMaxComparedPixels = 2'500'000;    // about 3 GiB

constexpr const char* kDescription =
    R"(Draws a scene lit by lamps in fog, without a display (OpenGL 3.3 through EGL).

  litfog-demo SCENE [OPTIONS]                        one picture
  litfog-demo gallery [SCENE...] [-o FOLDER]         every scene, clear and at its visibilities
  litfog-demo compare [SCENE...] [-o FOLDER]         every scene by every lighting path, with times and errors
  litfog-demo compare SCENE --with SETTING ...       a scene in several settings; a page that flips, wipes and zooms
  litfog-demo sequence SCENE [-o FOLDER]             frames over visibility, time, a camera path or any member
  litfog-demo papers [-o FOLDER]                     the papers' figures, drawn by their own programs
  litfog-demo window SCENE [OPTIONS]                 a window in which things can be moved and changed
  litfog-demo list scenes|paths                      what SCENE and --path may be
  litfog-demo list lights SCENE                      what --set may change of a scene's lights

Each has its own options: litfog-demo gallery --help
)";

constexpr const char* kExamples =
    R"(Examples:
  litfog-demo headlights --visibility 150 -o fog.png
  litfog-demo approach --fog exp2 --visibility 800 --size 1920x1080 -o approach.exr
  litfog-demo street.glb --exposure -8.5 -o street.png
  litfog-demo city --lights 4000 --visibility 500 -o city.png
  litfog-demo room --path vertex --heat-map error.png
  litfog-demo room --set lights[0].attenuation.quadratic=0.02 --camera 2,1.6,4 --target 0,1.5,-2
  litfog-demo gallery -o out
  litfog-demo compare room headlights --size 960x540 -o paths

Exit status: 0 done; 1 wrong usage; 2 bad scene or light file; 3 no OpenGL 3.3 through EGL, too few samples per
pixel, too little memory for the shadow maps, or no ffmpeg for --film; 4 output cannot be written.)";

/// One of the command's jobs. Its options are on the command line, and it runs once that has been parsed.
using Job = std::function<ExitStatus()>;

/// Paths of the named scenes, or of all bundled scenes.
std::vector<std::string> scene_paths(std::vector<std::string> scenes) {
  if (scenes.empty()) scenes = scene::bundled_scenes();
  std::ranges::transform(scenes, scenes.begin(), drawing::scene_path);
  return scenes;
}

/// Options of a single picture.
struct PictureOptions {
  drawing::SceneOptions scene;
  drawing::DrawingOptions drawing;
  std::string output;
  std::string heat_map;
  std::string stats;
  int frames = 1;
  bool reference = false;
  bool sorts_polygons = false;
  bool in_floats = false;
};

/// Throws the usage error of options that do not belong together.
void check_picture_options(const CLI::App& app, const PictureOptions& options) {
  const drawing::DrawingOptions& drawing = options.drawing;
  const auto is_given = [&app](const char* option) { return app.count(option) > 0; };
  if (!is_given("SCENE")) throw CLI::ValidationError("a scene must be given: see litfog-demo list scenes");
  auto rules = drawing::drawing_rules(drawing);
  rules.push_back(
      {"--flat-shading", is_given("--flat-shading"), {"--reference", "--heat-map"}, "references are shaded smoothly"});
  rules.push_back({"--fog-light airlight",
                   drawing.settings().fog_lighting == render::FogLighting::airlight,
                   {"--sort-polygons"},
                   "its lamps light surfaces beyond their extents"});
  rules.push_back({fmt::format("--path {}", drawing.render.path->name),
                   !drawing.render.path->has_reference,
                   {"--reference", "--heat-map"},
                   "it is one of the papers' programs that have none"});
  rules.push_back({"--output " + options.output,
                   drawing::holds_scene_light(options.output),
                   {"--exposure", "--tone", "--glare"},
                   "it holds the scene's light"});
  rules.push_back(
      {"a .png picture", !drawing::holds_scene_light(options.output), {"--exr"}, "it has 8 bits a channel"});
  check_options(app, rules);
  if (is_given("--output") && !drawing::is_picture_path(options.output)) {
    fail_option("--output", options.output, "must end in .png or .exr");
  }
  if (is_given("--heat-map") && std::filesystem::path(options.heat_map).extension() != ".png") {
    fail_option("--heat-map", options.heat_map, "must end in .png");
  }
  if (options.reference || is_given("--heat-map"))
    drawing::expect_pixels(drawing, kMaxReferencePixels, "for a reference");
}

ExitStatus draw_picture(const CLI::App& app, const PictureOptions& options) {
  const drawing::DrawingOptions& drawing = options.drawing;
  const auto is_given = [&app](const char* option) { return app.count(option) > 0; };
  const WallTimer timer;
  Progress progress;
  progress.show(fmt::format("{}: loading", options.scene.scene));
  scene::Scene scene = drawing::read_scene(options.scene);
  drawing::check_scene_options(app, scene);
  scene::move_to_time(scene, drawing.seconds);
  if (options.sorts_polygons) scene = render::sort_polygons(scene, drawing.settings());
  OutputFiles outputs;
  const std::string output = is_given("--output") ? options.output : scene.name + ".png";
  outputs.add("--output", output);
  if (is_given("--heat-map")) outputs.add("--heat-map", options.heat_map);
  if (is_given("--stats")) outputs.add("--stats", options.stats);
  for (const std::string& file : scene.files) outputs.expect_apart_from(file);
  outputs.expect_no_documents();

  const drawing::Drawn drawn =
      draw(scene, drawing, timer, progress, options.frames, options.reference || is_given("--heat-map"),
           is_given("--stats"), options.in_floats);
  if (is_given("--heat-map")) {
    drawing::write_picture(
        options.heat_map,
        drawing::make_heat_map(drawn.comparison->error, fmt::format("{}, {}", scene.name, drawing.render.path->name)));
  }
  const render::Picture& picture = options.reference ? drawn.comparison->reference : drawn.picture;
  std::optional<drawing::Display> display;
  if (!drawing::holds_scene_light(output)) display = drawn.display;
  drawing::write_picture(output, display ? drawing::displayed(picture, scene.camera, *display) : picture,
                         options.in_floats);
  if (is_given("--stats")) files::write_whole_file(options.stats, drawing::stats_json(scene, drawing, drawn, display));
  const std::string words = display               ? drawing::display_in_words(*display)
                            : is_cut_off(picture) ? "in 32-bit floats: light exceeds half floats' 65504"
                                                  : "";
  using measure::milliseconds_text;
  report(fmt::format(
      "{}: {} ({}x{}{}): loaded in {} ms, first drawn, with shaders compiled, in {} ms, then in {} ms on {}\n", output,
      scene.name, drawing.width, drawing.height, words.empty() ? "" : ", " + words, milliseconds_text(drawn.load_ms),
      milliseconds_text(drawn.first_ms), milliseconds_text(drawn.times.median()), drawn.gl_renderer));
  if (drawn.comparison) {
    report(fmt::format("{}: {}\n", drawing.render.path->name, measure::error_in_words(drawn.comparison->error)));
  }
  return kDone;
}

Job add_picture_job(CLI::App& app) {
  const auto options = std::make_shared<PictureOptions>();
  app.option_defaults()->group("Output");
  app.add_option("-o,--output", options->output,
                 "Picture to write: .png (what a display shows) or .exr (linear light) (default SCENE.png)")
      ->type_name("FILE");
  add_choice<bool>(app, "--exr", options->in_floats, {{"half", false}, {"float", true}},
                   "Number format of an .exr picture: 16-bit floats unless its light exceeds them, or 32-bit floats "
                   "(default half)");
  add_integer(app, "--frames", options->frames, 1, 100'000,
              "Frames to draw and time, after one that is not timed (default 1)");
  app.add_flag("--reference", options->reference,
               "Write the reference, shaded on the CPU in double by the path's plain formulas");
  app.add_option("--heat-map", options->heat_map, "Write the path's error against the reference as colours, .png")
      ->type_name("FILE");
  app.add_option("--stats", options->stats, "Write times and counts as JSON")->type_name("FILE");
  drawing::add_picture_options(app, options->scene, options->drawing);
  app.add_flag("--sort-polygons", options->sorts_polygons,
               "By peak: draw triangles that no lamp reaches with programs without lamps, as Hales advises");
  app.option_defaults()->group("Options");
  return [&app, options] {
    check_picture_options(app, *options);
    if (drawing::holds_scene_light(options->output)) options->drawing.display.glare = drawing::Glare::none;
    return draw_picture(app, *options);
  };
}

/// files  what is written besides pictures: ": a page"
void add_folder(CLI::App& app, std::string& folder, const std::string& files = "") {
  const auto take = [&folder](const std::string& text) {
    if (text.empty()) fail_option("--output", text, "must not be empty");
    folder = text;
  };
  app.option_defaults()->group("Output");
  app.add_option_function<std::string>("-o,--output", take,
                                       fmt::format("Folder to write into{} (default {})", files, folder))
      ->type_name("FOLDER");
}

/// Options of jobs over several scenes.
struct ScenesOptions {
  std::vector<std::string> scenes;
  std::string folder;
  drawing::DrawingOptions drawing;
};

void add_scenes_and_folder(CLI::App& app, ScenesOptions& options) {
  app.add_option("SCENE", options.scenes, "Scenes as those of a single picture (default: all that come with litfog)")
      ->type_name("");
  add_folder(app, options.folder);
}

Job add_gallery_job(CLI::App& app) {
  const auto options = std::make_shared<ScenesOptions>(ScenesOptions{.scenes = {}, .folder = "gallery", .drawing = {}});
  app.footer(
      "If airlight is the default, the first scene is also drawn by peak, for comparison. The scene tessellation is "
      "drawn only if it is named.\n\n"
      "Example:\n  litfog-demo gallery room headlights --size 640x360 -o out");
  add_scenes_and_folder(app, *options);
  drawing::add_fog(app, options->drawing);
  // With these the street takes 1.25 times as long; with shafts the room takes 1.75 times as long.
  options->drawing.render.shadows = render::Shadows::surfaces;
  drawing::add_drawing(app, options->drawing);
  return [&app, options] {
    const drawing::DrawingOptions& drawing = options->drawing;
    check_options(app, drawing::drawing_rules(drawing));
    const gl::HeadlessContext context;
    report(fmt::format("drawing on {}\n", context.renderer()));
    draw_gallery(scene_paths(options->scenes), options->scenes.empty(), options->folder, drawing);
    return kDone;
  };
}

struct ComparisonOptions : ScenesOptions {
  drawing::SceneOptions scene;
  std::vector<std::string> settings;
  int frames = kComparedFrames;
};

ExitStatus compare_by_settings(const CLI::App& app, const ComparisonOptions& options) {
  if (options.scenes.empty()) throw CLI::ValidationError("--with compares settings of one SCENE: name it");
  if (options.scenes.size() > 1) {
    throw CLI::ValidationError(
        fmt::format("--with compares settings of one SCENE, not of {}: a SETTING may be another, "
                    "as in --with {}",
                    options.scenes.size(), options.scenes[1]));
  }
  drawing::SceneOptions base = options.scene;
  base.scene = options.scenes.front();
  const auto settings = parse_settings(app, {"as it is", base, options.drawing}, options.settings);
  drawing::expect_pixels(options.drawing, kMaxComparedPixels, "for a comparison");
  const gl::HeadlessContext context;
  compare_settings(settings, options.folder, context.renderer(), options.frames);
  return kDone;
}

ExitStatus compare_by_paths(const CLI::App& app, const ComparisonOptions& options) {
  const drawing::DrawingOptions& drawing = options.drawing;
  check_options(app, drawing::fog_and_shadow_rules(drawing));
  check_options(app, {{"a comparison of lighting paths",
                       true,
                       {"--set", "--camera", "--target", "--fov-deg", "--path", "--flat-shading"},
                       "settings are given by --with"}});
  drawing::expect_pixels(drawing, kMaxComparedPixels, "for a comparison");
  // All scenes are read first, so that an error in one is found before minutes are spent on another.
  std::vector<scene::Scene> scenes = [&options] {
    Progress progress;
    progress.show("loading scenes");
    return scene::read_scenes(scene_paths(options.scenes));
  }();
  const bool changes = std::ranges::any_of(scenes, drawing::changes_with_time);
  check_options(app, {{"these scenes", !changes, {"--time"}, "none of their lights turns or flashes"}});
  for (scene::Scene& scene : scenes) scene::move_to_time(scene, drawing.seconds);
  const gl::HeadlessContext context;
  report(fmt::format("drawing {} scene{} on {}\n", scenes.size(), scenes.size() == 1 ? "" : "s", context.renderer()));
  compare_paths(scenes, options.folder, context.renderer(), drawing, options.frames);
  return kDone;
}

Job add_comparison_job(CLI::App& app) {
  const auto options = std::make_shared<ComparisonOptions>();
  options->folder = "comparison";
  app.footer(
      "SETTING is a picture's options without their dashes, members as for --set, or another scene, separated by "
      "spaces. A single SETTING is compared with the scene without it; other options apply to all. Without --with, "
      "scenes are drawn unchanged: --set, --camera, --target, --fov-deg, --path and --flat-shading need --with.\n\n"
      "Examples:\n"
      "  litfog-demo compare room --visibility 30 --size 960x540 -o paths\n"
      "  litfog-demo compare room --with \"visibility=50\" --with \"visibility=400 path=vertex\"\n"
      "  litfog-demo compare room --with lights[0].attenuation.quadratic=0.05 --with my-room.json --with no-skip");
  add_scenes_and_folder(app, *options);
  app.add_option("--with", options->settings,
                 "Compare settings of one scene instead of lighting paths; give it once per setting")
      ->type_name("SETTING")
      ->allow_extra_args(false);
  add_integer(app, "--frames", options->frames, 1, 100'000, "Frames of each path or setting to time (default 5)");
  drawing::add_changes(app, options->scene);
  drawing::add_time(app, options->drawing);
  drawing::add_view(app, options->scene);
  drawing::add_fog_and_visibility(app, options->drawing);
  drawing::add_drawing(app, options->drawing);
  return [&app, options] {
    return options->settings.empty() ? compare_by_paths(app, *options) : compare_by_settings(app, *options);
  };
}

Job add_sequence_job(CLI::App& app) {
  struct Options {
    SequenceOptions sequence;
    drawing::DrawingOptions drawing;
    std::string folder = "sequence";
  };
  const auto options = std::make_shared<Options>();
  app.footer(
      "NUMBERS is one number, a list A,B,C with one frame each, FROM..TO, or FROM..TO:N in N frames. Lights that the "
      "eye's vehicle carries move with the camera. The camera moves smoothly through the keyframes of a path file, "
      "whose times and angles are optional:\n"
      "  {\"litfog\": \"camera-path\", \"version\": 1, \"keyframes\": [\n"
      "    {\"time_s\": 0, \"position\": [0, 2, 9], \"target\": [0, 1, 0], \"field_of_view_deg\": 50}, ...]}\n\n"
      "Examples:\n"
      "  litfog-demo sequence room --visibility 400..10:24 -o out\n"
      "  litfog-demo sequence lighthouse --time 0..8 --frames 48 --film beam.mp4\n"
      "  litfog-demo sequence street --camera 0,1.6,20..0,1.6,-20 --target 0,1.6,-60\n"
      "  litfog-demo sequence room --set lights[0].attenuation.quadratic=0.02..0.5");
  app.add_option("SCENE", options->sequence.scene, "A scene as that of a single picture")->type_name("")->required();
  add_folder(app, options->folder, ": SCENE-0001.png and so on, and SCENE.apng, which plays them");
  add_sequence(app, options->sequence);
  drawing::add_fog(app, options->drawing);
  add_contrast(app, options->drawing.contrast);
  drawing::add_drawing(app, options->drawing);
  return [&app, options] {
    const drawing::DrawingOptions& drawing = options->drawing;
    if (app.count("--film") > 0 && !is_film_path(options->sequence.film)) {
      fail_option("--film", options->sequence.film, "must end in .mp4 or .webm");
    }
    check_options(app, drawing::drawing_rules(drawing));
    check_options(app, {{"--camera-path", app.count("--camera-path") > 0, {"--camera", "--target", "--fov-deg"}}});
    Sequence sequence(options->sequence);
    check_options(app, {{sequence.scene().name,
                         !drawing::changes_with_time(sequence.scene()),
                         {"--time"},
                         "none of its lights turns or flashes"}});
    const gl::HeadlessContext context;
    report(
        fmt::format("drawing {} frames of {} on {}\n", sequence.frames(), sequence.scene().name, context.renderer()));
    draw_sequence(sequence, options->folder, drawing);
    return kDone;
  };
}

Job add_papers_job(CLI::App& app) {
  struct Options {
    std::string folder = "papers";
    drawing::DrawingOptions drawing{.width = 480, .height = 270};
    int frames = kComparedFrames;
  };
  const auto options = std::make_shared<Options>();
  app.footer(
      "hales.png has the times of table 1 beside those measured now; software rendering times are not a GPU's.\n\n"
      "Example:\n  litfog-demo papers -o out");
  add_folder(app, options->folder);
  drawing::add_size(app, options->drawing);
  add_integer(app, "--frames", options->frames, 1, 100'000, "Frames of each program to time (default 5)");
  return [options] {
    papers::draw_paper_sheets(options->folder, options->drawing.width, options->drawing.height, options->frames);
    return kDone;
  };
}

Job add_list_job(CLI::App& app) {
  enum class What { scenes, paths, lights };
  struct Options {
    What what;
    drawing::SceneOptions scene;
    TableFormat format = TableFormat::text;
  };
  const auto options = std::make_shared<Options>();
  add_choice<What>(
      app, "WHAT", options->what, {{"scenes", What::scenes}, {"paths", What::paths}, {"lights", What::lights}},
      "scenes: those that come with litfog; paths: the lighting paths, each with its source; lights: those "
      "of SCENE, as --set takes them")
      ->required();
  app.footer("Example:\n  litfog-demo list lights approach --format json");
  drawing::add_scene(app, options->scene);
  drawing::add_changes(app, options->scene);
  add_choice(app, "--format", options->format,
             {{"table", TableFormat::text}, {"csv", TableFormat::csv}, {"json", TableFormat::json}},
             "How lights are listed (default table)");
  return [&app, options] {
    const bool has_scene = app.count("SCENE") > 0;
    if (options->what == What::lights) {
      if (!has_scene)
        throw CLI::ValidationError("list lights must be followed by a scene: see litfog-demo list scenes");
      write_standard_output(format_table(list_lights(drawing::read_scene(options->scene)), options->format));
      return kDone;
    }
    check_options(app,
                  {{"list scenes or list paths", true, {"SCENE", "--set", "--format"}, "only lights are a scene's"}});
    if (options->what == What::paths) {
      for (const render::LightingPath& path : render::all_paths()) {
        report(fmt::format("{:<13} {} ({})\n", path.name, path.description, path.source));
      }
      return kDone;
    }
    for (const std::string& name : scene::bundled_scenes()) {
      report(fmt::format("{:<12} {}\n", name, scene::read_scene(scene::bundled_scene_path(name)).description));
    }
    return kDone;
  };
}

Job add_window_job(CLI::App& app) {
  app.prefix_command();
  app.set_help_flag();  // litfog-window shows its own help
  return [&app]() -> ExitStatus { become_window(app.remaining()); };
}

/// Throws the usage error of a scene or an option of a single picture before another job's name.
void expect_nothing_before(const CLI::App& job, const CLI::App& app) {
  for (const CLI::Option* option : app.get_options()) {
    if (option->count() == 0) continue;
    throw CLI::ValidationError(option->get_name() + " cannot be given before " + job.get_name());
  }
}

}  // namespace

int main(int argc, char** argv) {
  expect_uncaught();
  CLI::App app{kDescription, "litfog-demo"};
  app.require_subcommand(0, 1);
  const Job picture_job = add_picture_job(app);
  std::vector<std::pair<CLI::App*, Job>> jobs;
  const auto add_job = [&](const char* name, const char* description, Job (*add)(CLI::App&)) {
    CLI::App* const job = app.add_subcommand(name, description);
    jobs.emplace_back(job, add(*job));
  };
  add_job("gallery", "Draws scenes clear and at each of their visibilities, and a contact sheet", add_gallery_job);
  add_job("compare",
          "Draws scenes by every lighting path, or one in several settings; times, differences and a page, index.html",
          add_comparison_job);
  add_job("sequence",
          "Draws a scene over visibility, time, a camera path or any member: numbered frames and an animation of them",
          add_sequence_job);
  add_job("papers", "Redraws the papers' figures by their own programs: a sheet for each paper, with Hales's table 1",
          add_papers_job);
  add_job("window", "Shows a scene in a window, in which fog, lighting, camera and lamps can be changed",
          add_window_job);
  add_job("list", "Lists the scenes that come with litfog, the lighting paths or a scene's lights", add_list_job);
  app.footer(kExamples);  // last, so that the jobs' help lacks it
  return run_command(app, argc, argv, [&] {
    try {
      for (const auto& [job, run] : jobs) {
        if (!job->parsed()) continue;
        expect_nothing_before(*job, app);
        return run();
      }
      return picture_job();
    } catch (const gl::Unsupported& missing) {
      throw MissingCapability(missing.what());
    }
  });
}
