// SPDX-License-Identifier: Apache-2.0
#include "window/session.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <utility>

#include "window/scene_changes.h"

namespace litfog::window {

Session::Session(drawing::SceneOptions given, scene::Scene scene, const drawing::DrawingOptions& both)
    : settings{both, both}, camera(scene.camera), given_(std::move(given)), scene_(std::move(scene)) {
  for (drawing::DrawingOptions& each : settings) {
    if (each.runway_visual_range) {
      each.visibility = each.visibility_of_runway_visual_range(*each.runway_visual_range);
      each.runway_visual_range.reset();
    }
    if (!each.visibility && each.layers && !each.layers->empty()) each.visibility = each.visibility_in(scene_);
    if (!each.visibility) each.visibility = scene::suggested_visibility(scene_);
  }
  Lamps lamps{.lights = scene_.lights, .entries = scene_.light_entries, .firsts = {}};
  lamps.firsts = lamps.found_firsts();
  lamps_ = given_lamps_ = std::make_shared<const Lamps>(std::move(lamps));
}

void Session::set_time(double seconds) {
  for (drawing::DrawingOptions& each : settings) each.seconds = std::min(seconds, scene::kMaxSeconds);
}

void Session::split(bool on) {
  if (on && !was_split_) settings[1] = settings[0];
  was_split_ = was_split_ || on;
  is_split = on;
  edited = on ? 1 : 0;
}

PlacedLight Session::light_now(std::size_t light) const {
  scene::Scene alone;
  alone.lights = {lights()[light]};
  if (const auto turn = scene_.turn_rates.find(light); turn != scene_.turn_rates.end()) {
    alone.turn_rates.emplace(0, turn->second);
  }
  scene::move_to_time(alone, time());
  return alone.lights[0];
}

void Session::look_as(const Session& other) {
  settings = other.settings;
  is_split = other.is_split;
  was_split_ = other.was_split_;
  edited = other.edited;
  wipe = other.wipe;
  runs = other.runs;
  is_false_colored = other.is_false_colored;
  motion = other.motion;
  if (other.is_camera_moved()) camera = other.camera;
}

drawing::SceneOptions Session::given_now() const {
  drawing::SceneOptions now = given_;
  now.changes = changes();
  now.city_lights = 0;  // the changes include it
  return now;
}

std::size_t Session::copies(std::size_t light) const {
  return std::size_t(std::ranges::count(lamps_->entries, lamps_->entries[light]));
}

void Session::change(std::size_t light, const PlacedLight& changed) {
  Lamps lamps = *lamps_;
  const PlacedLight& before = lights()[light];
  if (is_of_city(light) && (changed.position != before.position || changed.direction != before.direction)) {
    lamps.remove(light);
    lamps.add(changed, next_entry());
    if (picked == light) picked = lights().size();
    return take(std::move(lamps));
  }
  const glm::dvec3 step = changed.position - before.position;
  for (std::size_t i = 0; i < lamps.lights.size(); ++i) {
    if (!are_copies(i, light)) continue;
    PlacedLight& copy = lamps.lights[i];
    const std::string name = copy.light.name;
    copy.light = changed.light;
    copy.light.name = name;
    copy.position = i == light ? changed.position : copy.position + step;
    if (changed.direction != before.direction) copy.direction = changed.direction;
  }
  take(std::move(lamps));
}

void Session::reset(std::size_t light) {
  Lamps lamps = *lamps_;
  for (std::size_t i = 0; i < scene_.lights.size(); ++i) {
    if (are_copies(i, light)) lamps.lights[i] = scene_.lights[i];
  }
  take(std::move(lamps));
}

void Session::reset_all() {
  take(*given_lamps_);
  lamps_ = given_lamps_;
}

bool Session::is_changed(std::size_t light) const {
  return is_added(light) || !changes_of("", scene_.lights[light], lights()[light]).empty();
}

bool Session::is_movable(std::size_t light) const { return !scene_.mounts.contains(light); }

bool Session::is_of_city(std::size_t light) const {
  return !is_added(light) && scene_.light_members[scene_.light_entries[light]].starts_with("city.");
}

void Session::add(const PlacedLight& light) {
  Lamps lamps = *lamps_;
  picked = lamps.lights.size();
  lamps.add(light, next_entry());
  take(std::move(lamps));
}

void Session::remove(std::size_t light) {
  Lamps lamps = *lamps_;
  for (std::size_t i = 0; i < lamps.lights.size(); ++i) {
    if (i == light || (are_copies(i, light) && !is_of_city(light))) lamps.remove(i);
  }
  take(std::move(lamps));
}

void Session::Lamps::add(const PlacedLight& light, std::size_t entry) {
  lights.push_back(light);
  entries.push_back(entry);
}

void Session::Lamps::remove(std::size_t light) {
  lights[light].light.color = glm::dvec3(0);
  entries[light] = kRemoved;
}

std::vector<std::size_t> Session::Lamps::found_firsts() const {
  std::vector<std::size_t> found;
  std::vector<bool> is_met;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (entries[i] == kRemoved) continue;
    is_met.resize(std::max(is_met.size(), entries[i] + 1));
    if (!is_met[entries[i]]) found.push_back(i);
    is_met[entries[i]] = true;
  }
  return found;
}

void Session::take(Lamps lamps) {
  constexpr std::size_t kMaxKept = 1'000'000;  // lights in all steps: 300 MB
  if (!is_step_open_) undone_to_.push_back(lamps_);
  while (undone_to_.size() > 1 && undone_to_.size() * lights().size() > kMaxKept) undone_to_.erase(undone_to_.begin());
  redone_to_.clear();
  is_step_open_ = true;
  lamps.firsts = lamps.found_firsts();
  lamps_ = std::make_shared<const Lamps>(std::move(lamps));
  forget_removed_pick();
}

void Session::step_back(Steps& from, Steps& to) {
  if (from.empty()) return;
  to.push_back(std::exchange(lamps_, from.back()));
  from.pop_back();
  is_step_open_ = false;
  forget_removed_pick();
}

void Session::forget_removed_pick() {
  if (picked && (*picked >= lights().size() || lamps_->entries[*picked] == kRemoved)) picked.reset();
}

std::vector<scene::SceneChange> Session::changes() const {
  std::vector<scene::SceneChange> all = given_.changes;
  if (given_.city_lights > 0) all.push_back({"city.lights", std::to_string(given_.city_lights)});
  const std::vector<std::string>& members = scene_.light_members;
  auto entries = std::size_t(
      std::ranges::count_if(members, [](const std::string& member) { return member.starts_with("lights["); }));
  std::vector<bool> is_removed(members.size());
  for (const std::size_t i : given_lamps_->firsts) is_removed[scene_.light_entries[i]] = !is_of_city(i);
  for (const std::size_t i : firsts()) {
    if (is_added(i)) {
      all.push_back({"lights[" + std::to_string(entries++) + "]", light_entry(lights()[i])});
      continue;
    }
    is_removed[scene_.light_entries[i]] = false;
    const auto changes = changes_of(members[scene_.light_entries[i]], scene_.lights[i], lights()[i]);
    all.insert(all.end(), changes.begin(), changes.end());
  }
  for (std::size_t entry = members.size(); entry-- > 0;) {  // backwards, so that no removal shifts a later index
    if (is_removed[entry]) all.push_back({members[entry], "null"});
  }
  std::set<std::size_t> without = scene_.city_without;
  std::size_t in_city = 0;  // index in the list that `without` means
  for (std::size_t i = 0; i < scene_.lights.size(); ++i) {
    if (!is_of_city(i)) continue;
    while (scene_.city_without.contains(in_city)) ++in_city;
    if (lamps_->entries[i] == kRemoved) without.insert(in_city);
    ++in_city;
  }
  if (without != scene_.city_without) {
    all.push_back({"city.without", fmt::format("[{}]", fmt::join(without, ", "))});
  }
  return all;
}

PictureOrder Session::order(int width, int height, bool is_sketch) const {
  return {.settings = {settings.begin(), settings.begin() + (is_split ? 2 : 1)},
          .camera = camera,
          .lights = {lamps_, &lamps_->lights},
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
