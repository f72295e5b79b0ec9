// SPDX-License-Identifier: Apache-2.0
#include "demo/light_list.h"

#include <fmt/format.h>

#include <glm/trigonometric.hpp>
#include <map>

namespace litfog::demo {
namespace {

std::string cone_in_words(const scene::Scene& scene, std::size_t index) {
  if (scene.cookie_uses.contains(index)) return "cookie";
  const Cone& cone = scene.lights[index].light.cone;
  switch (cone.profile) {
    case ConeProfile::none:
      break;
    case ConeProfile::cosine:
      return fmt::format("cosine to {:.4g} deg, exponent {:.4g}", glm::degrees(cone.half_angle), cone.exponent);
    case ConeProfile::smoothstep:
      return fmt::format("smoothstep {:.4g} to {:.4g} deg", glm::degrees(cone.inner), glm::degrees(cone.outer));
  }
  return "all around";
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
  std::size_t next = 0;
  for (std::size_t entry = 0; entry < scene.light_copies.size(); ++entry) {
    add(fmt::format("lights[{}]", entry), scene.light_copies[entry], next);
    next += scene.light_copies[entry];
  }
  if (!scene.has_city) {
    for (; next < scene.lights.size(); ++next) add("", 1, next);
    return table;
  }
  std::map<std::string, std::pair<std::size_t, std::size_t>> kinds;  // by name: how many, and the first one
  for (; next < scene.lights.size(); ++next)
    ++kinds.try_emplace(scene.lights[next].light.name, 0, next).first->second.first;
  for (const auto& [name, kind] : kinds) add("city", kind.first, kind.second);
  return table;
}

}  // namespace litfog::demo
