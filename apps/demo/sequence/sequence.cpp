// SPDX-License-Identifier: Apache-2.0
#include "demo/sequence/sequence.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <set>
#include <string_view>

#include "command/command.h"
#include "command/output_files.h"
#include "command/progress.h"
#include "command/standard_output.h"
#include "command/wall_timer.h"
#include "demo/sequence/animation.h"
#include "drawing/drawing.h"
#include "drawing/picture_folder.h"
#include "files/whole_file.h"
#include "litfog/input_error.h"
#include "measure/progress.h"
#include "render/renderer.h"
#include "text/file_text.h"
#include "text/shown_number.h"

namespace litfog::demo {
namespace {

constexpr std::size_t kMaxFrameBytes = std::size_t{1} << 30;
constexpr command::NumberRule kFinite{[](double x) { return std::isfinite(x); }, "must be a finite number"};

template <typename Value>
bool changes(const std::optional<Course<Value>>& course) {
  return course && !course->is_constant();
}

void add_course(CLI::App& app, const std::string& name, std::optional<Course<double>>& target,
                const command::NumberRule& rule, Steps steps, const std::string& description) {
  app.add_option_function<std::string>(
         name,
         [name, &target, rule, steps](const std::string& text) { target = parse_course(name, text, rule, steps); },
         description)
      ->type_name("NUMBERS");
}

void add_point_course(CLI::App& app, const std::string& name, std::optional<Course<glm::dvec3>>& target,
                      const std::string& description) {
  app.add_option_function<std::string>(
         name, [name, &target](const std::string& text) { target = parse_point_course(name, text); }, description)
      ->type_name("X,Y,Z[..X,Y,Z]");
}

MemberCourse parse_member(const std::string& text) {
  MemberCourse member{.change = drawing::parse_change(text), .numbers = {}};
  scene::changed_member(member.change.member);  // throws if there is no such member
  if (is_meant_as_course(member.change.value)) {
    member.numbers = parse_course("--set " + member.change.member, member.change.value, kFinite);
  }
  return member;
}

/// Throws the usage error of a member that is set twice, because the later one would hide the earlier.
void expect_no_member_twice(const std::vector<MemberCourse>& members) {
  std::set<std::string> names;
  for (const MemberCourse& member : members) {
    if (names.insert(scene::changed_member(member.change.member)).second) continue;
    throw CLI::ValidationError(fmt::format("--set {}: must not be given twice", member.change.member));
  }
}

/// The number of frames that the options agree on.
int count_frames(const SequenceOptions& options) {
  expect_no_member_twice(options.members);
  int frames = options.frames;
  std::string first = "--frames";
  bool has_change = !options.camera_path.empty();
  const auto take = [&](const std::string& name, const auto& course) {
    if (!changes(course)) return;
    has_change = true;
    const std::optional<int> asked = course->frames();
    if (!asked) return;
    if (frames != 0 && *asked != frames) {
      throw CLI::ValidationError(
          fmt::format("{} has {} frames, and {} {}: the numbers must be equal", name, *asked, first, frames));
    }
    if (frames == 0) first = name;
    frames = *asked;
  };
  take("--visibility", options.visibility);
  take("--time", options.seconds);
  take("--camera", options.camera);
  take("--target", options.target);
  take("--fov-deg", options.field_of_view_deg);
  for (const MemberCourse& member : options.members) take("--set " + member.change.member, member.numbers);
  if (!has_change) throw CLI::ValidationError("nothing changes: give a range, such as --visibility 2000..50");
  return frames == 0 ? kDefaultFrames : frames;
}

/// Whether any member changes whose name has one of these beginnings.
bool change(const std::vector<MemberCourse>& members, std::initializer_list<std::string_view> beginnings) {
  return std::ranges::any_of(members, [&](const MemberCourse& course) {
    const std::string& member = course.change.member;
    return changes(course.numbers) &&
           std::ranges::any_of(beginnings, [&](std::string_view name) { return member.starts_with(name); });
  });
}

/// Moves a scene's carried lights as a camera moves, as if both were one rigid body.
void carry_lights(scene::Scene& scene, const scene::Camera& from, const scene::Camera& to) {
  const glm::dmat4 motion = glm::inverse(scene::view_from_world<double>(to)) * scene::view_from_world<double>(from);
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    PlacedLight& light = scene.lights[i];
    if (!light.carried) continue;
    light.position = glm::dvec3(motion * glm::dvec4(light.position, 1));
    light.direction = glm::normalize(glm::dmat3(motion) * light.direction);
    scene.mounts.erase(i);  // a mount holds the direction at rest
  }
}

std::string frame_file(const scene::Scene& scene, int frame) {
  return fmt::format("{}-{:04}.png", scene.name, frame + 1);
}

}  // namespace

void add_sequence(CLI::App& app, SequenceOptions& options) {
  app.option_defaults()->group("What changes");
  add_course(
      app, "--visibility", options.visibility, command::kNotNegative, Steps::ratio,
      "Range in metres at which a fraction of the contrast is left; FROM..TO has equal ratios (default: what the "
      "scene suggests)");
  add_course(app, "--time", options.seconds, drawing::kSeconds, Steps::even,
             "Time in seconds, for cookies and lights that turn or flash (default 0)");
  add_point_course(app, "--camera", options.camera, "The camera's position, metres (default the scene's)");
  add_point_course(app, "--target", options.target, "The point that it looks at, metres (default the scene's)");
  add_course(app, "--fov-deg", options.field_of_view_deg, drawing::kFieldOfView, Steps::even,
             "Its vertical field of view (default the scene's)");
  app.add_option("--camera-path", options.camera_path, "Keyframes of the camera in a file, instead of these three")
      ->type_name("FILE.json");
  app.add_option_function<std::vector<std::string>>(
         "--set",
         [&options](const std::vector<std::string>& texts) {
           for (const std::string& text : texts) options.members.push_back(parse_member(text));
         },
         "Change a member of the scene file, as for a single picture, to a value or through NUMBERS; may be given "
         "again")
      ->type_name("MEMBER=VALUE")
      ->allow_extra_args(false);
  app.option_defaults()->group("Output");
  command::add_integer(app, "--frames", options.frames, 2, kMaxFrames,
                       fmt::format("How many (default as many as a list or range asks for, else {})", kDefaultFrames));
  command::add_integer(app, "--fps", options.frames_per_second, 1, 100,
                       "Frames per second of SCENE.apng and the film (default 12)");
  app.add_option("--film", options.film, "Also write a film: .mp4 or .webm (needs ffmpeg)")->type_name("FILE");
}

Sequence::Sequence(const SequenceOptions& options)
    : options_(options), frames_(count_frames(options)), scene_(read(0)), own_camera_(scene_.camera) {
  if (!options.camera_path.empty()) {
    path_ = read_camera_path(options.camera_path, double(own_camera_.field_of_view));
    scene_.files.push_back(options.camera_path);
  }
  changes_members_ =
      std::ranges::any_of(options.members, [](const MemberCourse& member) { return changes(member.numbers); });
  changes_objects_ = change(options.members, {"objects[", "city."});
  moves_camera_ = path_ || changes(options.camera) || changes(options.target) || changes(options.field_of_view_deg);
  moves_lights_ = (changes(options.seconds) && drawing::changes_with_time(scene_)) ||
                  (moves_camera_ && std::ranges::any_of(scene_.lights, &PlacedLight::carried));
  // Finds an impossible frame before any is drawn: drawing takes some ten times as long as reading. The last frame
  // comes first: errors then name a number that the command line states.
  for (int frame = frames_ - 1; frame >= 0; --frame) {
    if (changes_members_ && frame > 0) own_camera_ = read(frame).camera;
    expect_heading(frame);
  }
  own_camera_ = scene_.camera;
  vehicle_camera_ = scene_.camera;
  lights_ = scene_.lights;
  cookie_uses_ = scene_.cookie_uses;
  show(0);
}

scene::Scene Sequence::read(int frame) {
  drawing::SceneOptions options{.scene = options_.scene};
  for (const MemberCourse& member : options_.members) {
    options.changes.push_back(member.change);
    if (member.numbers) options.changes.back().value = fmt::format("{}", member.numbers->at(frame, frames_));
  }
  scene::Scene scene = drawing::read_scene(options, &parts_);
  return scene;
}

scene::Camera Sequence::camera(int frame) const {
  if (path_) return path_->at(double(frame) / (frames_ - 1));
  scene::Camera camera = own_camera_;
  if (options_.camera) camera.position = options_.camera->at(frame, frames_);
  if (options_.target) camera.target = options_.target->at(frame, frames_);
  if (options_.field_of_view_deg) {
    camera.field_of_view = glm::radians(float(options_.field_of_view_deg->at(frame, frames_)));
  }
  return camera;
}

void Sequence::expect_heading(int frame) const {
  if (scene::has_heading(camera(frame))) return;
  const std::string sentence = fmt::format("frame {}: the target {}", frame + 1, scene::kHeadingRule);
  if (path_) throw InputError({.file = options_.camera_path}, sentence);
  throw CLI::ValidationError(sentence);
}

double Sequence::visibility(int frame) const {
  return options_.visibility ? options_.visibility->at(frame, frames_) : scene::suggested_visibility(scene_);
}

std::string Sequence::text(int frame) const {
  std::string text;
  const auto add = [&](const std::string& name, const auto& course, const char* unit) {
    if (!changes(course)) return;
    text +=
        fmt::format("{}{} {}{}", text.empty() ? "" : ", ", name, shown_rounded(course->at(frame, frames_), 4), unit);
  };
  add("visibility", options_.visibility, " m");
  add("time", options_.seconds, " s");
  add("field of view", options_.field_of_view_deg, " deg");
  for (const MemberCourse& member : options_.members) add(member.change.member, member.numbers, "");
  if (path_ || changes(options_.camera) || changes(options_.target)) {
    const glm::dvec3& eye = scene_.camera.position;
    text += fmt::format("{}camera {},{},{}", text.empty() ? "" : ", ", shown_rounded(eye.x, 4), shown_rounded(eye.y, 4),
                        shown_rounded(eye.z, 4));
  }
  return text;
}

void Sequence::show(int frame) {
  if (changes_members_ && frame > 0) {
    scene_ = read(frame);
    lights_ = scene_.lights;
    cookie_uses_ = scene_.cookie_uses;
    own_camera_ = scene_.camera;
  }
  scene_.camera = camera(frame);
  if (frame == 0 || changes_members_ || moves_lights_) move_lights(frame);
}

void Sequence::move_lights(int frame) {
  scene_.lights = lights_;
  scene_.cookie_uses = cookie_uses_;
  if (moves_camera_) carry_lights(scene_, vehicle_camera_, scene_.camera);
  scene::move_to_time(scene_, options_.seconds ? options_.seconds->at(frame, frames_) : 0);
}

void draw_sequence(Sequence& sequence, const std::string& folder, const drawing::DrawingOptions& drawing) {
  const command::WallTimer timer;
  const SequenceOptions& options = sequence.options();
  const scene::Scene& scene = sequence.scene();
  const int count = sequence.frames();
  if (!options.film.empty()) require_film_maker();
  std::vector<std::string> frame_files;
  for (int frame = 0; frame < count; ++frame) frame_files.push_back(frame_file(scene, frame));
  std::vector<std::string> files = frame_files;
  files.push_back(scene.name + ".apng");
  drawing::PictureFolder pictures(folder, files, scene.files);
  const std::string animation = pictures.path_of(files.back());
  if (!options.film.empty()) {
    command::OutputFiles outputs;
    outputs.add("--film", options.film);
    for (const std::string& file : scene.files) outputs.expect_apart_from(file);
  }

  const render::RenderSettings settings = drawing.settings();
  const bool chooses_casters = sequence.moves_camera() && settings.shadows != render::Shadows::none;
  command::Progress progress;
  progress.show(fmt::format("{}: loading", scene.name));
  render::Renderer renderer(scene, drawing.width, drawing.height, settings);
  drawing::Display display = drawing.display.display_for(scene, settings.fog_lighting);
  for (int frame = 0; frame < count; ++frame) {
    const command::WallTimer frame_timer;
    progress.show(fmt::format("{}: {}, frame {} of {}", scene.name, frame == 0 ? measure::kCompiling : "drawing",
                              frame + 1, count));
    if (frame > 0) {
      sequence.show(frame);
      if (sequence.changes_objects()) renderer.set_objects();
      if (sequence.changes_members() || sequence.moves_lights() || chooses_casters) renderer.set_lights();
    }
    renderer.set_atmosphere(drawing.atmosphere_of(scene, sequence.visibility(frame)));
    if (frame == 0) {
      display.exposure = renderer.set_exposure(display.exposure);
    } else {
      renderer.set_exposure({.ev = display.exposure.ev});
    }
    renderer.draw();
    const std::string& file = frame_files[std::size_t(frame)];
    pictures.write(file, drawing::displayed(drawing::whole_light(renderer, renderer.read()), scene.camera, display));
    command::report(fmt::format("{}: {}, drawn in {:.2f} s\n", pictures.path_of(file), sequence.text(frame),
                                frame_timer.seconds()));
  }
  pictures.finish();

  std::vector<std::string> frames;
  for (const std::string& file : frame_files) frames.push_back(read_file_text(pictures.path_of(file), kMaxFrameBytes));
  files::write_whole_file(animation, animated_png(frames, options.frames_per_second));
  if (!options.film.empty()) {
    files::write_whole_file(options.film, film(options.film, frames, options.frames_per_second));
  }
  const std::string words = drawing::display_in_words(display);
  command::report(fmt::format("{}{}: {} frames, {} a second{}; {:.1f} s in all\n", animation,
                              options.film.empty() ? "" : " and " + options.film, count, options.frames_per_second,
                              words.empty() ? "" : ", " + words, timer.seconds()));
}

}  // namespace litfog::demo
