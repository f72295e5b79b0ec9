// SPDX-License-Identifier: Apache-2.0
#include "scene/file/scene_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <climits>
#include <filesystem>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>
#include <random>
#include <set>
#include <stdexcept>

#include "command/bundled_data.h"
#include "command/exit_status.h"
#include "command/number.h"
#include "command/printable.h"
#include "files/hint.h"
#include "files/json_document.h"
#include "files/json_text.h"
#include "files/light_json.h"
#include "litfog/files/light_file.h"
#include "litfog/files/phase_name.h"
#include "litfog/fog_light_block.h"
#include "litfog/input_error.h"
#include "litfog/photometry/cookie_file.h"
#include "model/float_limit.h"
#include "scene/file/fog_layers.h"
#include "scene/file/gltf_scene.h"
#include "scene/model/city.h"
#include "scene/model/model_catalogue.h"
#include "scene/paint/cookie_pattern.h"
#include "scene/paint/material_catalogue.h"

namespace litfog::scene {
namespace {

using files::JsonValue;

constexpr std::size_t kMaxCopies = 20'000;  // copies of one object or light
constexpr std::size_t kMaxInstances = 50'000;
constexpr std::size_t kMaxCookies = 32;                         // OpenGL 3.3 promises 256 layers, six per cookie
constexpr std::size_t kMaxCookieTexels = std::size_t{1} << 28;  // 1 GiB of floats
constexpr double kMaxDensityScale = 1e6;

const std::vector<std::string_view> kLightEntryMembers{
    "light", "position", "aim", "direction", "mount", "color", "cookie", "turn_deg_per_s", "carried", "repeat"};
/// A light's members that a change may name without ".light".
const std::vector<std::string_view> kMembersOfTheLight{"attenuation", "threshold", "cone", "density_scale"};

bool is_color(const glm::dvec3& color) {
  return is_within(color.r, 0, kMaxColor) && is_within(color.g, 0, kMaxColor) && is_within(color.b, 0, kMaxColor);
}
const std::string kColorRule = fmt::format("must be a colour of numbers in [0, {}]", kMaxColor);

// So a light that is read here is valid (find_error(PlacedLight)).
static_assert(kMaxCoordinate <= kMaxPosition);
bool is_position(const glm::dvec3& position) {
  return glm::all(glm::lessThanEqual(glm::abs(position), glm::dvec3(kMaxCoordinate)));
}
const std::string kPositionRule = fmt::format("must have coordinates in [{}, {}]", -kMaxCoordinate, kMaxCoordinate);

/// The same path for a file however it is spelled.
std::filesystem::path canonical_path(const std::filesystem::path& path) {
  std::error_code error;
  const auto found = std::filesystem::weakly_canonical(path, error);
  return error ? path : found;
}

glm::dvec3 position_of(const JsonValue& value) {
  glm::dvec3 position = value.vec3();
  for (int i = 0; i < 3; ++i) position[i] = snapped(position[i], -kMaxCoordinate, kMaxCoordinate);
  if (!is_position(position)) value.fail(kPositionRule);
  return position;
}

/// Fails if a light file states a number beyond the renderer's floats.
const Light& checked(const JsonValue& value, const Light& light) {
  if (!is_color(light.color)) value.fail(value.path() + ".color", "", kColorRule);
  if (!is_within(light.density_scale, 0, kMaxDensityScale)) {
    value.fail(value.path() + ".density_scale", fmt::format("{}", light.density_scale),
               fmt::format("must be at most {}", kMaxDensityScale));
  }
  return light;
}

glm::vec3 color_or(const JsonValue& object, std::string_view name, const glm::vec3& absent) {
  const auto value = object.optional(name);
  if (!value) return absent;
  const glm::dvec3 color = value->vec3();
  if (!is_color(color)) value->fail(kColorRule);
  return color;
}

glm::dvec3 direction(const JsonValue& value) {
  const glm::dvec3 vector = value.vec3();
  if (!(glm::length(vector) > 1e-9 && glm::length(vector) < 1e9)) value.fail("must have a length in (1e-9, 1e9)");
  return glm::normalize(vector);
}

double number_in(const JsonValue& value, double low, double high) {
  const double number = snapped(value.number(), low, high);
  if (!(number >= low && number <= high)) value.fail(fmt::format("must be in [{}, {}]", low, high));
  return number;
}

double number_in_or(const JsonValue& object, std::string_view name, double low, double high, double absent) {
  const auto value = object.optional(name);
  return value ? number_in(*value, low, high) : absent;
}

std::size_t count_in(const JsonValue& value, std::size_t most, std::size_t least = 1) {
  const double count = number_in(value, double(least), double(most));
  if (count != std::floor(count)) value.fail("must be a whole number");
  return std::size_t(count);
}

/// The positions of an object's copies; only its own without "repeat".
std::vector<glm::dvec3> read_repeat(const JsonValue& object, const glm::dvec3& position) {
  std::vector<glm::dvec3> positions{position};
  const auto repeats = object.optional("repeat");
  if (!repeats) return positions;
  for (const JsonValue& repeat : repeats->items()) {
    repeat.allow_only({"count", "step"});
    const std::size_t count = count_in(repeat.member("count"), kMaxCopies);
    const glm::dvec3 step = repeat.member("step").vec3();
    if (count * positions.size() > kMaxCopies) {
      repeat.member("count").fail(fmt::format("must not make more than {} copies in all", kMaxCopies));
    }
    const std::size_t before = positions.size();
    for (std::size_t i = 1; i < count; ++i) {
      for (std::size_t k = 0; k < before; ++k) positions.push_back(positions[k] + step * double(i));
    }
    if (!std::ranges::all_of(positions, is_position)) {
      repeat.member("step").fail("every copy's position " + kPositionRule);
    }
  }
  return positions;
}

Camera read_camera(const JsonValue& value) {
  value.allow_only({"position", "target", "field_of_view_deg"});
  const Camera camera{.position = position_of(value.member("position")),
                      .target = position_of(value.member("target")),
                      .field_of_view = glm::radians(
                          float(number_in_or(value, "field_of_view_deg", kMinFieldOfViewDeg, kMaxFieldOfViewDeg, 50)))};
  if (!has_heading(camera)) value.member("target").fail(kHeadingRule);
  return camera;
}

Environment read_environment(const JsonValue& value) {
  value.allow_only({"ambient", "fog_color", "sky_zenith", "sky_horizon", "stars", "moon"});
  Environment environment;
  environment.ambient_light = color_or(value, "ambient", environment.ambient_light);
  environment.sky_zenith = color_or(value, "sky_zenith", environment.sky_zenith);
  environment.sky_horizon = color_or(value, "sky_horizon", environment.sky_horizon);
  environment.star_brightness = float(number_in_or(value, "stars", 0, 100, 0));
  if (const auto moon = value.optional("moon")) {
    moon->allow_only({"direction", "color"});
    environment.moon_direction = direction(moon->member("direction"));
    environment.moon_color = color_or(*moon, "color", glm::vec3{0.0f});
  }
  return environment;
}

double angle_or(const JsonValue& object, std::string_view name, double most_deg) {
  return glm::radians(number_in_or(object, name, -most_deg, most_deg, 0));
}

/// The vehicle that carries mounted lights.
struct Vehicle {
  glm::dvec3 position{0.0};
  Attitude attitude;

  /// right_up_back  to the right, up, and back, metres
  glm::dvec3 point(const glm::dvec3& right_up_back) const {
    const glm::dvec3 ahead_left_up(-right_up_back.z, -right_up_back.x, right_up_back.y);
    return position + glm::transpose(viewpoint_from_world(attitude)) * ahead_left_up;
  }
};

Phase read_phase(const JsonValue& value) {
  const auto phase = files::phase_named(value.string());
  if (!phase) value.fail(files::kPhaseRule);
  return *phase;
}

void read_atmosphere(const JsonValue& value, Scene& scene) {
  value.allow_only({"phase", "albedo", "layers"});
  Atmosphere& air = scene.atmosphere;
  if (const auto phase = value.optional("phase")) {
    if (scene.states_phase) phase->fail("must not stand beside phase_g");
    air.phase = read_phase(*phase);
    scene.states_phase = true;
  }
  if (const auto albedo = value.optional("albedo")) {
    air.albedo = albedo->number();
    if (const auto error = find_error(air)) albedo->fail(error->rule);
  }
  if (const auto layers = value.optional("layers")) {
    scene.layers = read_fog_layers(*layers);
    air.profile = make_density_profile(scene.layers);
  }
}

SceneDisplay read_display(const JsonValue& value) {
  value.allow_only({"exposure", "tone"});
  SceneDisplay display;
  if (const auto exposure = value.optional("exposure")) {
    if (exposure->is_string()) {
      if (exposure->string() != "auto") exposure->fail("must be auto or a number in [-32, 32]");
      display.exposure.reset();
    } else {
      display.exposure = number_in(*exposure, -kMaxExposure, kMaxExposure);
    }
  }
  if (const auto tone = value.optional("tone")) {
    const std::string name = tone->string();
    if (name != "neutral" && name != "clip") tone->fail_choice({"neutral", "clip"});
    display.is_clipped = name == "clip";
  }
  return display;
}

Vehicle read_vehicle(const JsonValue& value) {
  value.allow_only({"position", "heading_deg", "pitch_deg", "roll_deg"});
  return {.position = position_of(value.member("position")),
          .attitude = {.heading = angle_or(value, "heading_deg", 360),
                       .pitch = angle_or(value, "pitch_deg", 90),
                       .roll = angle_or(value, "roll_deg", 180)}};
}

/// Parses a change's value. Text that does not begin like JSON stands for a string.
JsonValue changed_value(const SceneChange& change) {
  const std::string& value = change.value;
  const bool is_json = value.empty() || value.find_first_of("{[\"-0123456789") == 0 || value == "true" ||
                       value == "false" || value == "null";
  return files::parse_json(is_json ? value : files::json_quoted(value),
                           fmt::format("{} {}", kChangePlace, change.member));
}

/// The index of the light that a change of a glTF file means; none if it is not a number.
std::optional<std::size_t> changed_light(const SceneChange& change) {
  constexpr std::string_view kLights = "lights[";
  if (!change.member.starts_with(kLights)) {
    throw InputError({.file = kChangePlace}, change.member, "",
                     "must be a member of a light, such as lights[0].color: a glTF file has no others");
  }
  return command::parse_integer(change.member.substr(kLights.size(), change.member.find(']') - kLights.size()));
}

/// Reads scenes; shares light files and models between the entries that name them.
class SceneReader {
 public:
  SceneReader(const std::string& path, std::optional<std::size_t> city_lights, const std::vector<SceneChange>& changes,
              SceneParts* kept)
      : folder_(std::filesystem::path(path).parent_path()), kept_(kept) {
    scene_.files.push_back(path);
    JsonValue root = files::read_json(path);
    for (const SceneChange& change : changes) root = changed(root, change);
    expect_header(root, "scene", 1);
    root.allow_only({"litfog", "version", "name", "description", "camera", "environment", "visibilities_m",
                     "lit_at_vertices", "fog_top_m", "phase_g", "atmosphere", "display", "vehicle", "lights", "city",
                     "objects"});
    read_name(root, std::filesystem::path(path).stem().string());
    if (const auto description = root.optional("description")) scene_.description = description->string();
    scene_.camera = read_camera(root.member("camera"));
    Atmosphere& air = scene_.atmosphere;
    if (const auto environment = root.optional("environment")) {
      scene_.environment = read_environment(*environment);
      air.ambient_fog_color = color_or(*environment, "fog_color", glm::vec3(0.0f));
    }
    if (const auto visibilities = root.optional("visibilities_m")) read_visibilities(*visibilities);
    if (const auto is_at_vertices = root.optional("lit_at_vertices")) {
      scene_.is_lit_at_vertices = is_at_vertices->boolean();
    }
    air.top = root.number_or("fog_top_m", air.top);
    if (const auto phase_g = root.optional("phase_g")) {
      air.phase = Phase::henyey_greenstein(phase_g->number());
      if (const auto error = find_error(air.phase)) phase_g->fail(error->rule);
      scene_.states_phase = true;
    }
    if (const auto atmosphere = root.optional("atmosphere")) read_atmosphere(*atmosphere, scene_);
    if (const auto display = root.optional("display")) scene_.display = read_display(*display);
    if (const auto vehicle = root.optional("vehicle")) vehicle_ = read_vehicle(*vehicle);
    if (const auto lights = root.optional("lights")) {
      for (const JsonValue& light : lights->items()) read_light_entry(light);
    }
    const auto city = root.optional("city");
    if (city) read_city(*city, city_lights);
    if (!city || root.optional("objects")) {
      for (const JsonValue& object : root.member("objects").items()) read_object(object);
    }
    read_materials();
    if (kept_) *kept_ = std::move(used_);
  }

  /// Changes a glTF file's lights.
  SceneReader(Scene gltf, const std::vector<SceneChange>& changes)
      : folder_(std::filesystem::path(gltf.files.front()).parent_path()), kept_(nullptr), scene_(std::move(gltf)) {
    const std::string& file = scene_.files.front();
    const std::vector<PlacedLight> given = std::exchange(scene_.lights, {});
    scene_.light_members.clear();
    scene_.light_entries.clear();
    std::vector<std::optional<std::size_t>> unchanged;  // by item, the index in `given`; the item is then empty
    std::string items;
    for (std::size_t i = 0; i < given.size(); ++i) {
      unchanged.push_back(i);
      items += i == 0 ? "{}" : ", {}";
    }
    JsonValue root = files::parse_json("{\"lights\": [" + items + "]}", file);
    for (const SceneChange& change : changes) {
      const std::size_t index = changed_light(change).value_or(unchanged.size());
      if (index < unchanged.size() && unchanged[index]) {
        const JsonValue entry = files::parse_json(light_entry(given[*unchanged[index]]), file);
        root = files::with_value(root, fmt::format("lights[{}]", index), entry, file);
        unchanged[index].reset();
      }
      root = changed(root, change);
      const std::size_t count = root.member("lights").items().size();
      if (count < unchanged.size()) unchanged.erase(unchanged.begin() + std::ptrdiff_t(index));
      unchanged.resize(count);
    }
    const std::vector<JsonValue> lights = root.member("lights").items();
    for (std::size_t i = 0; i < lights.size(); ++i) {
      if (!unchanged[i]) {
        read_light_entry(lights[i]);
        continue;
      }
      scene_.light_members.push_back(lights[i].path());
      add_light(lights[i], given[*unchanged[i]]);
    }
  }

  Scene take() { return std::move(scene_); }

 private:
  JsonValue changed(const JsonValue& root, const SceneChange& change) {
    return files::with_value(root, changed_member(change.member), changed_value(change), kChangePlace,
                             [this](const JsonValue& link) { return linked_light(link); });
  }

  void read_name(const JsonValue& root, const std::string& absent) {
    constexpr const char* kRule =
        "must not be empty, start with a dot or hold '/' or control characters: files take it";
    const auto name = root.optional("name");
    scene_.name = name ? name->string() : absent;
    const bool is_file_name = !scene_.name.empty() && scene_.name.front() != '.' &&
                              scene_.name.find('/') == scene_.name.npos &&
                              std::ranges::none_of(scene_.name, [](unsigned char c) { return c < ' ' || c == 127; });
    if (name && name->string().size() > NAME_MAX) {
      name->fail(fmt::format("must be at most {} bytes: files take it", NAME_MAX));
    }
    if (is_file_name) return;
    if (name) name->fail(kRule);
    root.fail("name", files::quoted_excerpt(scene_.name), kRule);
  }

  void read_visibilities(const JsonValue& value) {
    const auto items = value.items();
    if (items.size() > 16) value.fail("must be at most 16 visibilities");
    for (const JsonValue& item : items) {
      if (!(item.number() > 0)) item.fail("must be > 0");
      if (std::ranges::find(scene_.visibilities, item.number()) != scene_.visibilities.end()) {
        item.fail("must not be given twice");
      }
      scene_.visibilities.push_back(item.number());
    }
  }

  /// The path of a file that is named relative to the scene's folder.
  std::string file_of(const JsonValue& name) const {
    if (name.string().size() > PATH_MAX) name.fail(fmt::format("must be a file's name of at most {} bytes", PATH_MAX));
    return (folder_ / name.string()).string();
  }

  /// The result of `read` for the light file that a string names.
  template <typename Read>
  auto from_light_file(const JsonValue& name, const Read& read) {
    scene_.files.push_back(file_of(name));
    try {
      return read(scene_.files.back());
    } catch (const InputError& error) {
      name.fail(std::string("must be a light file: ") + error.what());
    }
  }

  /// The document of a light file for a change of its members; nothing if the string names no light file.
  std::optional<JsonValue> linked_light(const JsonValue& link) {
    const std::string name(link.name());
    const bool is_light = (link.path().starts_with("lights[") && name == "light") || link.path() == "city." + name;
    if (!is_light) return std::nullopt;
    return from_light_file(link, [](const std::string& file) {
      const JsonValue document = files::read_json(file);
      if (!document.is_object() || document.optional("name")) return document;
      const std::string stem = std::filesystem::path(file).stem().string();
      return files::with_value(document, "name", files::parse_json(files::json_quoted(stem), file), file);
    });
  }

  Light read_kind(const JsonValue& value) {
    if (!value.is_string()) return checked(value, parse_light(value));
    const auto [entry, is_new] = lights_.try_emplace(value.string());
    if (is_new) entry->second = from_light_file(value, read_light);
    return checked(value, entry->second);
  }

  void read_light_entry(const JsonValue& value) {
    value.allow_only(kLightEntryMembers);
    PlacedLight light{.light = read_kind(value.member("light")), .position = position_of(value.member("position"))};
    if (value.optional("color")) light.light.color = color_or(value, "color", glm::vec3(1));
    light.direction = {0, -1, 0};
    std::optional<Mount> mount;
    if (const auto given = value.optional("mount")) {
      mount = read_mount(value, *given);
      light.position = vehicle_->point(light.position);
      if (!is_position(light.position)) value.member("position").fail(kPositionRule + " in the world, too");
      light.direction = glm::transpose(light_from_world(mount->light, mount->vehicle))[0];
    } else if (const auto aim = value.optional("aim")) {
      if (const auto twice = value.optional("direction")) twice->fail("must not stand beside aim");
      const glm::dvec3 axis = position_of(*aim) - light.position;
      if (!(glm::length(axis) > 1e-9)) aim->fail("must not be at the light's position");
      light.direction = glm::normalize(axis);
    } else if (const auto axis = value.optional("direction")) {
      light.direction = direction(*axis);
    }
    std::optional<CookieUse> cookie;
    if (const auto given = value.optional("cookie")) {
      cookie = read_cookie_use(*given);
      light.light.cone = Cone{};
    }
    const double turn_rate = glm::radians(number_in_or(value, "turn_deg_per_s", -3600, 3600, 0));
    if (const auto carried = value.optional("carried")) light.carried = carried->boolean();
    scene_.light_members.push_back(value.path());
    for (const glm::dvec3& position : read_repeat(value, light.position)) {
      light.position = position;
      if (cookie) scene_.cookie_uses.emplace(scene_.lights.size(), *cookie);
      if (mount) scene_.mounts.emplace(scene_.lights.size(), *mount);
      if (turn_rate != 0) scene_.turn_rates.emplace(scene_.lights.size(), turn_rate);
      add_light(value, light);
    }
  }

  /// Adds a light that the last member states.
  void add_light(const JsonValue& value, const PlacedLight& light) {
    scene_.light_entries.push_back(scene_.light_members.size() - 1);
    scene_.lights.push_back(light);
    if (scene_.lights.size() > kMaxSceneLights) {
      value.fail("lights", "", fmt::format("must be at most {}", kMaxSceneLights));
    }
    if (light.carried && ++carried_ > kMaxFogLights) {
      value.fail("lights", "", fmt::format("must be at most {} that are carried", kMaxFogLights));
    }
  }

  Mount read_mount(const JsonValue& light, const JsonValue& value) const {
    for (const char* member : {"aim", "direction", "cookie", "turn_deg_per_s", "repeat"}) {
      if (const auto twice = light.optional(member)) twice->fail("must not stand beside mount");
    }
    if (!vehicle_) value.fail("must be in a scene with a vehicle");
    value.allow_only({"azimuth_deg", "elevation_deg"});
    return {
        .vehicle = vehicle_->attitude,
        .light = {.azimuth = angle_or(value, "azimuth_deg", 360), .elevation = angle_or(value, "elevation_deg", 90)}};
  }

  void read_city(const JsonValue& value, std::optional<std::size_t> lights) {
    std::vector<std::string_view> members{"lights", "seed", "without"};
    for (const CityLightKind& kind : kCityLightKinds) members.emplace_back(kind.name);
    value.allow_only(members);
    City city;
    if (const auto count = value.optional("lights")) city.lights = count_in(*count, kMaxCityLights);
    if (lights) city.lights = *lights;
    city.seed = std::uint32_t(number_in_or(value, "seed", 0, kMaxSeed, city.seed));
    for (const CityLightKind& kind : kCityLightKinds) city.*kind.light = read_kind(value.member(kind.name));
    if (const auto without = value.optional("without")) {
      for (const JsonValue& light : without->items()) city.without.insert(count_in(light, kMaxCityLights - 1, 0));
    }
    scene_.has_city = true;
    scene_.city_without = city.without;
    try {
      add_city(scene_, city);
    } catch (const std::invalid_argument& error) {
      value.fail("city", "", error.what());
    }
    for (const Instance& instance : scene_.instances) triangles_ += triangle_count(scene_.models[instance.model]);
  }

  CookieUse read_cookie_use(const JsonValue& value) {
    value.allow_only({"image", "pattern", "roll_deg", "spin_deg_per_s"});
    return {.cookie = read_cookie_image(value),
            .roll = glm::radians(number_in_or(value, "roll_deg", -360, 360, 0)),
            .spin = glm::radians(number_in_or(value, "spin_deg_per_s", -3600, 3600, 0))};
  }

  /// The cookie of a file or pattern, read once for all lights that have it.
  std::size_t read_cookie_image(const JsonValue& value) {
    const auto pattern = value.optional("pattern");
    if (pattern && value.optional("image")) pattern->fail("must not stand beside image");
    const JsonValue source = pattern ? *pattern : value.member("image");
    const std::string name = pattern ? source.string() : canonical_path(file_of(source)).string();
    if (pattern && std::ranges::find(kCookiePatterns, name) == std::end(kCookiePatterns)) {
      source.fail(fmt::format("must be {}", fmt::join(kCookiePatterns, " or ")));
    }
    const auto [entry, is_new] = cookies_.try_emplace({pattern.has_value(), name}, scene_.cookies.size());
    if (is_new) {
      if (scene_.cookies.size() == kMaxCookies)
        value.fail(fmt::format("must be one of at most {} cookies", kMaxCookies));
      try {
        if (!pattern) scene_.files.push_back(file_of(source));
        scene_.cookies.push_back(kept_or_made(&SceneParts::cookies, entry->first, [&] {
          return pattern ? paint_cookie(name) : read_cookie(scene_.files.back());
        }));
      } catch (const InputError& error) {
        source.fail(std::string("must be a cookie: ") + error.what());
      }
      const auto largest = std::size_t(std::ranges::max(scene_.cookies, {}, &Cookie::size).size);
      if (scene_.cookies.size() * 6 * largest * largest > kMaxCookieTexels) {  // a renderer scales them to one size
        source.fail(fmt::format("must leave the scene's cookies, all as large as the largest, at most {} texels",
                                kMaxCookieTexels));
      }
    }
    return entry->second;
  }

  void read_object(const JsonValue& value) {
    const std::size_t model = read_model(value);
    const glm::dvec3 position = value.optional("position") ? position_of(value.member("position")) : glm::dvec3{0.0};
    const float heading = glm::radians(float(number_in_or(value, "heading_deg", -360, 360, 0)));
    const double scale = number_in_or(value, "scale", 0.001, 1000, 1);
    if (const auto scatter = value.optional("scatter")) {
      if (const auto repeat = value.optional("repeat")) repeat->fail("must not stand beside scatter");
      read_scatter(*scatter, model, position.y, scale);
      return;
    }
    for (const glm::dvec3& copy : read_repeat(value, position)) add_instance(value, model, copy, heading, scale);
  }

  void read_scatter(const JsonValue& value, std::size_t model, double height, double scale) {
    value.allow_only({"count", "area", "seed", "scale"});
    const std::size_t count = count_in(value.member("count"), kMaxCopies);
    const auto area = value.member("area").items();
    if (area.size() != 4) value.member("area").fail("must be x and z of one corner, then of the other");
    for (const JsonValue& side : area) number_in(side, -kMaxCoordinate, kMaxCoordinate);
    double low = 1;
    double high = 1;
    if (const auto range = value.optional("scale")) {
      const auto ends = range->items();
      if (ends.size() != 2) range->fail("must be two numbers");
      low = number_in(ends[0], 0.001, 1000);
      high = number_in(ends[1], low, 1000);
    }
    // Not HashRandom: another sequence would move objects in existing scenes. The standard fixes this engine's numbers,
    // but not those of the distributions.
    std::minstd_rand random(unsigned(number_in_or(value, "seed", 1, 1e9, 1)));
    const auto between = [&](double from, double to) {
      return from + (to - from) * (double(random()) / double(std::minstd_rand::max()));
    };
    for (std::size_t i = 0; i < count; ++i) {
      const double x = between(area[0].number(), area[2].number());
      const double z = between(area[1].number(), area[3].number());
      const float heading = float(between(0, 2 * std::numbers::pi));
      add_instance(value, model, {x, height, z}, heading, scale * between(low, high));
    }
  }

  /// The model of an object, made once for all objects with the same parameters.
  std::size_t read_model(const JsonValue& value) {
    const JsonValue name = value.member("model");
    const ModelInfo* info = find_model(name.string());
    if (!info) {
      std::vector<std::string_view> names;
      for (const ModelInfo& known : models()) names.push_back(known.name);
      name.fail_choice(names);
    }
    std::vector<std::string_view> allowed{"model", "position", "heading_deg", "scale", "repeat", "scatter"};
    ModelParameters parameters;
    std::string key = name.string();
    for (const ParameterInfo& parameter : info->parameters) {
      allowed.push_back(parameter.name);
      if (const auto given = value.optional(parameter.name)) {
        if (const auto rule = find_error(parameter, given->number())) given->fail(*rule);
        parameters.emplace(parameter.name, given->number());
        key += fmt::format(" {}={}", parameter.name, given->number());
      }
    }
    value.allow_only(allowed);
    const auto [entry, is_new] = models_.try_emplace(key, scene_.models.size());
    if (is_new) {
      try {
        scene_.models.push_back(
            kept_or_made(&SceneParts::models, key, [&] { return make_model(name.string(), parameters); }));
      } catch (const std::invalid_argument& error) {  // a rule across parameters is broken
        name.fail("model", name.string(), error.what());
      }
    }
    return entry->second;
  }

  /// A part kept from an earlier reading, or else a new one.
  template <typename Key, typename Part, typename Make>
  Part kept_or_made(std::map<Key, Part> SceneParts::*parts, const Key& key, const Make& make) {
    if (!kept_) return make();
    auto kept = (kept_->*parts).extract(key);
    if (!kept) return (used_.*parts).emplace(key, make()).first->second;
    return (used_.*parts).insert(std::move(kept)).position->second;
  }

  void read_materials() {
    std::set<std::string> names;
    for (const Model& model : scene_.models) {
      for (const Part& part : model) names.insert(part.material);
    }
    if (kept_) {
      for (const auto& [name, material] : kept_->materials) {
        if (names.contains(name)) scene_.materials.push_back(material);
      }
    }
    add_materials(scene_);
    for (const Material& material : scene_.materials) used_.materials.emplace(material.name, material);
  }

  void add_instance(const JsonValue& at, std::size_t model, const glm::dvec3& position, float heading, double scale) {
    triangles_ += triangle_count(scene_.models[model]);
    if (triangles_ > kMaxTriangles) at.fail("triangles", "", fmt::format("must be at most {}", kMaxTriangles));
    if (scene_.instances.size() == kMaxInstances) {
      at.fail("objects", "", fmt::format("must be at most {} with all copies", kMaxInstances));
    }
    glm::dmat4 world_from_model = glm::scale(place({}, heading), glm::vec3(float(scale)));
    world_from_model[3] = glm::dvec4(position, 1);
    scene_.instances.push_back({model, world_from_model});
  }

  std::filesystem::path folder_;
  SceneParts* kept_;
  SceneParts used_;  // replaces the kept parts
  Scene scene_;
  std::optional<Vehicle> vehicle_;
  std::map<std::string, Light> lights_;
  std::map<std::pair<bool, std::string>, std::size_t> cookies_;  // by name and whether they are patterns
  std::map<std::string, std::size_t> models_;
  std::size_t triangles_ = 0;
  std::size_t carried_ = 0;
};

std::filesystem::path scene_folder() { return command::bundled_folder("scenes"); }

}  // namespace

std::string light_entry(const PlacedLight& light) {
  const auto vector = [](const glm::dvec3& v) { return fmt::format("[{}, {}, {}]", v.x, v.y, v.z); };
  return fmt::format(R"({{"light": {}, "position": {}, "direction": {}{}}})", format_light(light.light),
                     vector(light.position), vector(light.direction), light.carried ? R"(, "carried": true)" : "");
}

std::string changed_member(const std::string& member) {
  constexpr std::size_t kLongest = 200;  // longer than any member's path; errors quote it
  if (member.size() > kLongest) {
    throw InputError({.file = kChangePlace}, files::quoted_excerpt(member), "",
                     "must be a member such as lights[0].position");
  }
  const std::size_t dot = member.find("].") + 1;
  if (!member.starts_with("lights[") || dot == 0) return member;
  const std::string name = member.substr(dot + 1, member.find_first_of(".[", dot + 1) - dot - 1);
  const auto is_one_of = [&name](const auto& names) { return std::ranges::find(names, name) != std::end(names); };
  if (name.empty() || is_one_of(kLightEntryMembers)) return member;
  if (is_one_of(kMembersOfTheLight)) return member.substr(0, dot) + ".light" + member.substr(dot);
  std::vector<std::string_view> names = kLightEntryMembers;
  names.insert(names.end(), kMembersOfTheLight.begin(), kMembersOfTheLight.end());
  throw InputError({.file = kChangePlace}, member, "",
                   fmt::format("{} must be one of {}{}", files::quoted_excerpt(name), fmt::join(names, ", "),
                               files::hint_for_word(name, names)));
}

Scene read_scene(const std::string& path, std::optional<std::size_t> city_lights,
                 const std::vector<SceneChange>& changes, SceneParts* kept) {
  if (!is_gltf_path(path)) return SceneReader(path, city_lights, changes, kept).take();
  Scene scene;
  if (kept && kept->gltf_scenes.contains(path)) {
    scene = kept->gltf_scenes.at(path);
  } else {
    scene = read_gltf_scene(path);
    if (kept) *kept = {.gltf_scenes = {{path, scene}}};
  }
  if (!changes.empty()) scene = SceneReader(std::move(scene), changes).take();
  static std::set<std::string> told;  // once, though a program may draw the file again and again
  const std::string line = command::printable(fmt::format("{}: left out: {}", path, scene.left_out));
  if (!scene.left_out.empty() && told.insert(line).second) fmt::print(stderr, "{}\n", line);
  return scene;
}

std::vector<Scene> read_scenes(const std::vector<std::string>& paths) {
  std::vector<Scene> scenes;
  for (const std::string& path : paths) {
    scenes.push_back(read_scene(path));
    const std::string& name = scenes.back().name;
    const auto earlier = std::ranges::find(scenes, name, &Scene::name);
    if (const auto i = std::size_t(earlier - scenes.begin()); i + 1 < scenes.size()) {
      throw InputError({.file = path}, "name", name, fmt::format("must not be that of {} too", paths[i]));
    }
  }
  return scenes;
}

std::vector<std::string> bundled_scenes() {
  std::vector<std::string> names;
  std::error_code missing;
  for (const auto& entry : std::filesystem::directory_iterator(scene_folder(), missing)) {
    if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
  }
  if (names.empty())
    throw InputError({.file = scene_folder().string()}, "cannot be read: litfog's scenes are not there");
  std::ranges::sort(names);
  return names;
}

std::string bundled_scene_path(const std::string& name) { return (scene_folder() / (name + ".json")).string(); }

}  // namespace litfog::scene
