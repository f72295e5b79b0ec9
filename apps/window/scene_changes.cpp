// SPDX-License-Identifier: Apache-2.0
#include "window/scene_changes.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <glm/glm.hpp>
#include <nlohmann/json.hpp>

#include "litfog/input_error.h"
#include "scene/file/gltf_scene.h"

namespace litfog::window {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// A file that has been read before, with all its rules.
Json read_again(const std::string& path) {
  std::ifstream file(path);
  Json json = Json::parse(file, nullptr, /* allow_exceptions */ false);
  if (!json.is_object()) throw InputError({.file = path}, "has been changed since it was read");
  return json;
}

std::size_t copies_of(const Json& entry) {
  std::size_t copies = 1;
  for (const Json& repeat : entry.value("repeat", Json::array())) copies *= repeat.value("count", std::size_t{1});
  return copies;
}

Json cone_json(const Cone& cone) {
  const auto degrees = [](double radians) { return std::stod(fmt::format("{:.12g}", glm::degrees(radians))); };
  if (cone.profile == ConeProfile::cosine) {
    return {{"profile", "cosine"}, {"half_angle_deg", degrees(cone.half_angle)}, {"exponent", cone.exponent}};
  }
  return {{"profile", "smoothstep"}, {"inner_deg", degrees(cone.inner)}, {"outer_deg", degrees(cone.outer)}};
}

/// A member of an object, made with the objects that it is in: "attenuation.quadratic".
Json& member_of(Json& object, std::string_view path) {
  const auto dot = path.find('.');
  Json& member = object[std::string(path.substr(0, dot))];
  return dot == path.npos ? member : member_of(member, path.substr(dot + 1));
}

/// Makes a path beside one file one beside another.
void move_path(Json& path, const fs::path& from, const fs::path& to) {
  const fs::path file = fs::absolute(from).parent_path() / path.get<std::string>();
  path = file.lexically_normal().lexically_proximate(fs::absolute(to).parent_path().lexically_normal()).string();
}

/// Moves the paths in an object that is itself a light file's name or a light.
void move_light(Json& light, const fs::path& from, const fs::path& to) {
  if (light.is_string()) move_path(light, from, to);
}

std::vector<double> rounded(const glm::vec3& v) {  // as short as floats that read back
  const auto shortest = [](float x) { return std::stod(fmt::format("{}", x)); };
  return {shortest(v.x), shortest(v.y), shortest(v.z)};
}

}  // namespace

std::string SceneChange::text() const { return fmt::format("lights[{}].{}={}", entry, member, value); }

std::vector<std::optional<std::size_t>> entries_of_lights(const scene::Scene& scene) {
  std::vector<std::optional<std::size_t>> entries;
  if (!scene::is_gltf_path(scene.files.front())) {
    const Json file = read_again(scene.files.front());
    const Json lights = file.value("lights", Json::array());
    for (std::size_t i = 0; i < lights.size(); ++i) entries.insert(entries.end(), copies_of(lights[i]), i);
  }
  entries.resize(scene.lights.size());
  return entries;
}

std::vector<SceneChange> changes_of(std::size_t entry, const Light& from, const Light& to) {
  std::vector<SceneChange> changes;
  const auto compare = [&](const char* member, double was, double is) {
    if (was != is) changes.push_back({entry, member, Json(is).dump()});
  };
  compare("attenuation.constant", from.attenuation.constant, to.attenuation.constant);
  compare("attenuation.linear", from.attenuation.linear, to.attenuation.linear);
  compare("attenuation.quadratic", from.attenuation.quadratic, to.attenuation.quadratic);
  compare("threshold", from.threshold, to.threshold);
  compare("density_scale", from.density_scale, to.density_scale);
  if (to.cone != from.cone) changes.push_back({entry, "cone", cone_json(to.cone).dump()});
  if (to.color != from.color) changes.push_back({entry, "color", Json(rounded(glm::vec3(to.color))).dump()});
  return changes;
}

std::string changed_scene(const std::string& file, const std::optional<scene::Camera>& camera,
                          const std::vector<SceneChange>& changes, const std::string& place) {
  Json scene = read_again(file);
  if (camera) {
    scene["camera"] = {{"position", rounded(camera->position)},
                       {"target", rounded(camera->target)},
                       {"field_of_view_deg", std::stod(fmt::format("{:.7g}", glm::degrees(camera->field_of_view)))}};
  }
  std::vector<bool> is_inline(scene.value("lights", Json::array()).size());
  for (const SceneChange& change : changes) {
    Json& entry = scene["lights"].at(change.entry);
    Json& light = entry["light"];
    if (light.is_string() && change.member != "color") {
      const fs::path light_file = fs::path(file).parent_path() / light.get<std::string>();
      light = read_again(light_file.string());
      if (!light.contains("name")) light["name"] = light_file.stem().string();
      light.erase("fit");  // it tells of the light that was fitted
    }
    member_of(change.member == "color" ? entry : light, change.member) = Json::parse(change.value);
  }
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
