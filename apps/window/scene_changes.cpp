// SPDX-License-Identifier: Apache-2.0
#include "window/scene_changes.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <glm/glm.hpp>
#include <nlohmann/json.hpp>

#include "command/number.h"
#include "litfog/files/light_file.h"
#include "litfog/input_error.h"

namespace litfog::window {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Reads a file again that has already passed all rules.
Json read_again(const std::string& path) {
  std::ifstream file(path);
  Json json = Json::parse(file, nullptr, /* allow_exceptions */ false);
  if (!json.is_object()) throw InputError({.file = path}, "has been changed since it was read");
  return json;
}

Json cone_json(const Cone& cone) {
  const auto degrees = [](double radians) {
    return *command::parse_number(fmt::format("{:.12g}", glm::degrees(radians)));
  };
  Json json{{"profile", facts_of(cone.profile).name}};
  for (const ConeParameter& parameter : facts_of(cone.profile).parameters) {
    const double value = cone.*parameter.member;
    json[parameter.file_name] = parameter.is_angle ? degrees(value) : value;
  }
  return json;
}

/// The keys of a path such as "lights[0].light.attenuation.quadratic".
std::vector<std::string> keys_of(const std::string& member) {
  std::vector<std::string> keys;
  for (std::size_t begin = 0; begin < member.size();) {
    const std::size_t end = std::min(member.find_first_of(".[]", begin), member.size());
    if (end > begin) keys.push_back(member.substr(begin, end - begin));
    begin = end + 1;
  }
  return keys;
}

/// Replaces a light file's name by its contents.
void write_out(Json& name, const fs::path& folder) {
  const fs::path file = folder / name.get<std::string>();
  Json light = read_again(file.string());
  if (!light.contains("name")) light["name"] = file.stem().string();
  light.erase("fit");  // it describes the light as fitted
  name = std::move(light);
}

/// Applies a change like files::with_value().
void apply(Json& scene, const scene::SceneChange& change, const fs::path& folder) {
  Json* value = &scene;
  Json* holder = nullptr;
  std::string last;
  for (const std::string& key : keys_of(scene::changed_member(change.member))) {
    if (value->is_string()) write_out(*value, folder);
    holder = value;
    last = key;
    const bool is_index = value->is_array() || (value->is_null() && key.find_first_not_of("0123456789") == key.npos);
    value = is_index ? &(*value)[std::stoul(key)] : &(*value)[key];
  }
  *value = Json::parse(change.value, nullptr, /* allow_exceptions */ false);
  if (value->is_discarded()) *value = change.value;  // a word
  if (!value->is_null()) return;
  if (holder->is_array())
    holder->erase(std::stoul(last));
  else
    holder->erase(last);
}

/// Changes a path relative to one file into a path relative to another.
void move_path(Json& path, const fs::path& from, const fs::path& to) {
  const fs::path file = fs::absolute(from).parent_path() / path.get<std::string>();
  path = file.lexically_normal().lexically_proximate(fs::absolute(to).parent_path().lexically_normal()).string();
}

/// Moves the paths in a light file's name or a light.
void move_light(Json& light, const fs::path& from, const fs::path& to) {
  if (light.is_string()) move_path(light, from, to);
}

std::vector<double> rounded(const glm::vec3& v) {  // the shortest numbers that give the same floats
  const auto shortest = [](float x) { return *command::parse_number(fmt::format("{}", x)); };
  return {shortest(v.x), shortest(v.y), shortest(v.z)};
}

std::vector<double> exact(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

}  // namespace

std::vector<scene::SceneChange> changes_of(const std::string& member, const PlacedLight& was, const PlacedLight& is) {
  const Light& from = was.light;
  const Light& to = is.light;
  std::vector<scene::SceneChange> changes;
  const auto add = [&](const char* name, const Json& value) { changes.push_back({member + "." + name, value.dump()}); };
  const auto compare = [&](const char* name, double before, double after) {
    if (before != after) add(name, after);
  };
  const bool is_moved = is.position != was.position;
  if (is_moved) add("position", exact(is.position));
  if (is.direction != was.direction || (is_moved && facts_of(to.cone.profile).profile != ConeProfile::none)) {
    add("aim", nullptr);  // an aim would turn the light as it moves
    add("direction", exact(is.direction));
  }
  compare("attenuation.constant", from.attenuation.constant, to.attenuation.constant);
  compare("attenuation.linear", from.attenuation.linear, to.attenuation.linear);
  compare("attenuation.quadratic", from.attenuation.quadratic, to.attenuation.quadratic);
  compare("threshold", from.threshold, to.threshold);
  compare("density_scale", from.density_scale, to.density_scale);
  if (to.cone != from.cone) add("cone", cone_json(to.cone));
  if (to.color != from.color) add("color", rounded(glm::vec3(to.color)));
  return changes;
}

std::string light_entry(const PlacedLight& light) {
  Json entry = Json::parse(scene::light_entry(light));
  entry["light"].erase("litfog");  // only light files need these members
  entry["light"].erase("version");
  return entry.dump();
}

std::string changed_scene(const std::string& file, const std::optional<scene::Camera>& camera,
                          const std::vector<scene::SceneChange>& changes, const std::string& place) {
  Json scene = read_again(file);
  if (camera) {
    scene["camera"] = {
        {"position", {camera->position.x, camera->position.y, camera->position.z}},
        {"target", {camera->target.x, camera->target.y, camera->target.z}},
        {"field_of_view_deg", *command::parse_number(fmt::format("{:.7g}", glm::degrees(camera->field_of_view)))}};
  }
  for (const scene::SceneChange& change : changes) apply(scene, change, fs::path(file).parent_path());
  if (!scene.contains("lights")) scene["lights"] = Json::array();
  for (Json& entry : scene["lights"]) {
    move_light(entry["light"], file, place);
    if (entry.contains("cookie") && entry["cookie"].contains("image")) move_path(entry["cookie"]["image"], file, place);
  }
  if (scene.contains("city")) {
    for (auto& [name, light] : scene["city"].items()) move_light(light, file, place);
  }
  return scene.dump(2) + "\n";
}

}  // namespace litfog::window
