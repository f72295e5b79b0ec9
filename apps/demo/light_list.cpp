// SPDX-License-Identifier: Apache-2.0
#include "demo/jobs.h"

#include <fmt/format.h>

#include <vector>

#include "files/light_json.h"

namespace litfog::demo {
namespace {

std::string cone_in_words(const scene::Scene& scene, std::size_t index) {
  if (scene.cookie_uses.contains(index)) return "cookie";
  const Cone& cone = scene.lights[index].light.cone;
  if (cone.is_point_light()) return "all around";
  return fmt::format("{}, {}", facts_of(cone.profile).name, files::shown_parameters(cone));
}

}  // namespace

command::Table list_lights(const scene::Scene& scene) {
  command::Table table{{"member", "lights", "name", "x_m", "y_m", "z_m", "constant", "linear", "quadratic", "threshold",
                        "extent_m", "cone", "density_scale", "carried"},
                       {}};
  const auto add = [&](const std::string& member, std::size_t count, std::size_t index) {
    const auto& [light, position, direction, carried] = scene.lights[index];
    const Attenuation& a = light.attenuation;
    table.rows.push_back({member, double(count), light.name, position.x, position.y, position.z, a.constant, a.linear,
                          a.quadratic, light.threshold, compute_extent(a, light.threshold), cone_in_words(scene, index),
                          light.density_scale, carried ? "yes" : "no"});
  };
  struct Entry {
    std::size_t count = 0;
    std::size_t first = 0;  // index of the first light in the scene
  };
  std::vector<Entry> entries(scene.light_members.size());
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    Entry& entry = entries[scene.light_entries[i]];
    if (entry.count++ == 0) entry.first = i;
  }
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (entries[i].count > 0) add(scene.light_members[i], entries[i].count, entries[i].first);
  }
  return table;
}

}  // namespace litfog::demo
