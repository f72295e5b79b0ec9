// SPDX-License-Identifier: Apache-2.0
#include "drawing/scene_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "command/command.h"
#include "command/number.h"
#include "files/hint.h"
#include "litfog/input_error.h"
#include "model/float_limit.h"
#include "scene/model/city.h"

namespace litfog::drawing {
namespace {

const std::string kPointRule =
    fmt::format("must be three numbers in [{}, {}], X,Y,Z", -scene::kMaxCoordinate, scene::kMaxCoordinate);

void add_point(CLI::App& app, const std::string& name, std::optional<glm::dvec3>& target,
               const std::string& description) {
  app.add_option_function<std::string>(
         name, [name, &target](const std::string& text) { target = parse_point(name, text); }, description)
      ->type_name("X,Y,Z");
}

}  // namespace

const command::NumberRule kFieldOfView{
    [](double x) { return x >= scene::kMinFieldOfViewDeg && x <= scene::kMaxFieldOfViewDeg; },
    "must be a number in [1, 150]", scene::kMinFieldOfViewDeg, scene::kMaxFieldOfViewDeg};

void add_scene(CLI::App& app, SceneOptions& options) {
  app.add_option("SCENE", options.scene,
                 "A scene that comes with litfog (litfog-demo list scenes), a scene file or a glTF file")
      ->type_name("");
}

void add_changes(CLI::App& app, SceneOptions& options) {
  app.option_defaults()->group("Scene");
  app.add_option_function<std::vector<std::string>>(
         "--set",
         [&options](const std::vector<std::string>& texts) {
           for (const std::string& text : texts) options.changes.push_back(parse_change(text));
         },
         "Change a member of the scene file, or of a light file that it names, before it is read: "
         "lights[0].attenuation.quadratic=0.002 (see litfog-demo list lights SCENE); null removes it; may be given "
         "again")
      ->type_name("MEMBER=VALUE")
      ->allow_extra_args(false);
  app.add_flag("--lamps-only", options.is_lit_by_lamps_alone,
               "Leave out all light except the lamps': ambient light, sky, stars, moon, fog colour");
}

void add_city_lights(CLI::App& app, SceneOptions& options) {
  command::add_integer(app, "--lights", options.city_lights, 1, int(scene::kMaxCityLights),
                       "Lights of a generated city (default the scene's)");
}

void add_view(CLI::App& app, SceneOptions& options) {
  app.option_defaults()->group("View");
  add_point(app, "--camera", options.camera, "The camera's position, metres (default the scene's)");
  add_point(app, "--target", options.target, "The point that it looks at, metres (default the scene's)");
  app.add_option_function<std::string>(
         "--fov-deg",
         [&options](const std::string& text) {
           const auto angle = command::parse_number(text, kFieldOfView);
           if (!angle) command::fail_option("--fov-deg", text, kFieldOfView.text);
           options.field_of_view_deg = angle;
         },
         "Its vertical field of view (default the scene's)")
      ->type_name("DEGREES");
}

scene::Scene read_scene(const SceneOptions& options, scene::SceneParts* kept) {
  const auto city_lights = options.city_lights > 0 ? std::optional(std::size_t(options.city_lights)) : std::nullopt;
  scene::Scene scene = scene::read_scene(scene_path(options.scene), city_lights, options.changes, kept);
  if (options.is_lit_by_lamps_alone) {
    scene.environment = {};
    scene.atmosphere.ambient_fog_color = {};
  }
  scene::Camera& camera = scene.camera;
  if (options.camera) camera.position = *options.camera;
  if (options.target) camera.target = *options.target;
  if (options.field_of_view_deg) camera.field_of_view = glm::radians(float(*options.field_of_view_deg));
  if (scene::has_heading(camera)) return scene;
  const glm::dvec3& at = options.target ? camera.target : camera.position;
  command::fail_option(
      options.target ? "--target" : "--camera", fmt::format("{},{},{}", at.x, at.y, at.z),
      fmt::format("must not be straight above or below the {}, or at it", options.target ? "camera" : "target"));
}

scene::SceneChange parse_change(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == 0 || equals == text.npos) {
    command::fail_option("--set", text, "must be MEMBER=VALUE, such as lights[0].attenuation.quadratic=0.002");
  }
  return {.member = text.substr(0, equals), .value = text.substr(equals + 1)};
}

glm::dvec3 parse_point(const std::string& option, const std::string& text) {
  const std::vector<std::string_view> parts = command::split_at_commas(text);
  if (parts.size() != 3) command::fail_option(option, text, kPointRule);
  glm::dvec3 point;
  for (int i = 0; i < 3; ++i) {
    const auto number = command::parse_number(parts[std::size_t(i)]);
    if (!number || !is_within(*number, -scene::kMaxCoordinate, scene::kMaxCoordinate))
      command::fail_option(option, text, kPointRule);
    point[i] = *number;
  }
  return point;
}

std::string scene_path(const std::string& scene) {
  const std::filesystem::path path(scene);
  if (path.filename() != scene) return scene;
  std::error_code error;
  const std::string bundled = scene::bundled_scene_path(scene);
  if (std::filesystem::exists(bundled, error)) return bundled;
  if (path.has_extension() || std::filesystem::exists(path, error)) return scene;
  const std::vector<std::string> names = scene::bundled_scenes();
  throw InputError({.file = scene}, fmt::format("must be a scene file or one of {}{}", fmt::join(names, ", "),
                                                files::hint_for_word(scene, {names.begin(), names.end()})));
}

bool changes_with_time(const scene::Scene& scene) {
  return !scene.turn_rates.empty() ||
         std::ranges::any_of(scene.lights, [](const PlacedLight& each) { return each.light.flash.count > 0; }) ||
         std::ranges::any_of(scene.cookie_uses, [](const auto& use) { return use.second.spin != 0; });
}

}  // namespace litfog::drawing
