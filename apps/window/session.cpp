// SPDX-License-Identifier: Apache-2.0
#include "window/session.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "window/scene_changes.h"

namespace litfog::window {

Session::Session(drawing::SceneOptions given, scene::Scene scene, const drawing::DrawingOptions& both)
    : settings{both, both},
      camera(scene.camera),
      given_(std::move(given)),
      scene_(std::move(scene)),
      lights_(std::make_shared<const std::vector<PlacedLight>>(scene_.lights)) {
  for (drawing::DrawingOptions& each : settings) {
    if (each.runway_visual_range) {
      each.visibility = each.visibility_of_runway_visual_range(*each.runway_visual_range);
      each.runway_visual_range.reset();
    }
    if (!each.visibility) each.visibility = scene::suggested_visibility(scene_);
  }
  std::vector<bool> is_met(scene_.light_members.size());
  for (std::size_t i = 0; i < scene_.lights.size(); ++i) {
    const std::size_t entry = scene_.light_entries[i];
    if (!is_met[entry]) firsts_.push_back(i);
    is_met[entry] = true;
  }
}

void Session::split(bool on) {
  if (on && !was_split_) settings[1] = settings[0];
  was_split_ = was_split_ || on;
  is_split = on;
  edited = on ? 1 : 0;
}

std::size_t Session::copies(std::size_t light) const {
  return std::size_t(std::ranges::count(scene_.light_entries, scene_.light_entries[light]));
}

void Session::change(std::size_t light, const Light& changed) {
  auto lights = std::make_shared<std::vector<PlacedLight>>(*lights_);
  for (std::size_t i = 0; i < lights->size(); ++i) {
    if (!are_copies(i, light)) continue;
    Light& copy = (*lights)[i].light;
    const std::string name = copy.name;
    copy = changed;
    copy.name = name;
  }
  lights_ = std::move(lights);
}

bool Session::is_changed(std::size_t light) const {
  return !changes_of("", scene_.lights[light].light, lights()[light].light).empty();
}

std::vector<scene::SceneChange> Session::changes() const {
  std::vector<scene::SceneChange> all = given_.changes;
  if (given_.city_lights > 0) all.push_back({"city.lights", std::to_string(given_.city_lights)});
  for (const std::size_t i : firsts_) {
    const std::string& member = scene_.light_members[scene_.light_entries[i]];
    const auto changes = changes_of(member, scene_.lights[i].light, lights()[i].light);
    all.insert(all.end(), changes.begin(), changes.end());
  }
  return all;
}

PictureOrder Session::order(int width, int height, bool is_sketch) const {
  return {.settings = {settings.begin(), settings.begin() + (is_split ? 2 : 1)},
          .camera = camera,
          .lights = lights_,
          .width = width,
          .height = height,
          .is_sketch = is_sketch};
}

DrawingCommand Session::command(std::size_t which, int width, int height) const {
  DrawingCommand command{given_.scene, settings[which], own_camera(), changes(), given_.is_lit_by_lamps_alone};
  command.options.width = width;
  command.options.height = height;
  return command;
}

Fog Session::fog(std::size_t which) const { return settings[which].fog_at(settings[which].visibility_in(scene_)); }

bool Session::is_camera_moved() const { return camera != scene_.camera; }

std::optional<scene::Camera> Session::own_camera() const {
  const bool is_given = given_.camera || given_.target || given_.field_of_view_deg;
  return is_given || is_camera_moved() ? std::optional(camera) : std::nullopt;
}

render::Picture wiped(const render::Picture& left, const render::Picture& right, double fraction) {
  render::Picture picture = left;
  const auto from = std::ptrdiff_t(std::lround(fraction * left.width)) * 3;
  const auto row = std::ptrdiff_t(left.width) * 3;
  for (std::ptrdiff_t begin = 0; begin < std::ptrdiff_t(picture.rgb.size()); begin += row) {
    std::copy(right.rgb.begin() + begin + from, right.rgb.begin() + begin + row, picture.rgb.begin() + begin + from);
  }
  return picture;
}

std::string free_file_name(const std::string& stem, const std::string& ending) {
  for (int number = 1;; ++number) {
    std::string name = stem + "-" + std::to_string(number) + ending;
    if (!std::filesystem::exists(name)) return name;
  }
}

}  // namespace litfog::window
