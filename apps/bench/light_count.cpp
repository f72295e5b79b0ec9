// SPDX-License-Identifier: Apache-2.0
#include "bench/light_count.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/glm.hpp>
#include <numeric>

namespace litfog::bench {
namespace {

using scene::Camera;
using scene::Scene;

/// Point i of an even sequence over the unit square: R2 (Roberts 2018, "The Unreasonable Effectiveness of Quasirandom
/// Sequences").
glm::dvec2 strewn(std::size_t i) {
  constexpr double kPlastic = 1.32471795724474602596;
  const double n = double(i + 1);
  return {std::fmod(0.5 + n / kPlastic, 1.0), std::fmod(0.5 + n / (kPlastic * kPlastic), 1.0)};
}

/// A position before the camera for a point of the unit square: even over the camera's field of view in the level plane
/// through the eye.
glm::dvec3 place_in_view(const scene::Camera& camera, glm::dvec2 point) {
  const glm::dvec3 eye = camera.position;
  glm::dvec3 forward = glm::dvec3(camera.target) - eye;
  const double farthest = 1.5 * glm::length(forward);
  forward = glm::normalize(glm::dvec3(forward.x, 0, forward.z));
  const glm::dvec3 right(-forward.z, 0, forward.x);
  const double range = farthest * std::sqrt(point.x);  // the view widens with range
  constexpr double kAspect = 16.0 / 9;                 // the same in every picture measured
  const double half_width = range * kAspect * std::tan(double(camera.field_of_view) / 2);
  return eye + forward * range + right * (half_width * (2 * point.y - 1));
}

}  // namespace

scene::Scene with_light_count(scene::Scene scene, std::size_t count) {
  assert(!scene.lights.empty() && count >= 1);
  std::vector<std::size_t> order(scene.lights.size());
  std::iota(order.begin(), order.end(), 0);
  const auto is_carried = [&](std::size_t i) { return scene.lights[i].carried; };
  const auto distance = [&](std::size_t i) {
    return glm::distance(scene.lights[i].position, glm::dvec3(scene.camera.position));
  };
  const auto first_local = std::stable_partition(order.begin(), order.end(), is_carried);
  std::stable_sort(first_local, order.end(), [&](std::size_t a, std::size_t b) { return distance(a) < distance(b); });
  const std::vector<std::size_t> sources = first_local == order.end() ? order : std::vector(first_local, order.end());

  const std::vector<PlacedLight> lights = std::move(scene.lights);
  const auto uses = std::move(scene.cookie_uses);
  scene.lights.clear();
  scene.cookie_uses.clear();
  scene.mounts.clear();  // the lights' own directions hold
  const std::size_t copies = count > order.size() ? count - order.size() : 0;
  const auto add = [&](std::size_t source) -> PlacedLight& {
    if (const auto use = uses.find(source); use != uses.end()) {
      scene.cookie_uses.emplace(scene.lights.size(), use->second);
    }
    scene.lights.push_back(lights[source]);
    return scene.lights.back();
  };
  const double fraction = double(sources.size()) / double(sources.size() + copies);
  for (std::size_t i = 0; i < std::min(count, order.size()); ++i) {
    PlacedLight& light = add(order[i]);
    if (copies > 0 && std::ranges::find(sources, order[i]) != sources.end()) light.light.color *= fraction;
  }
  for (std::size_t i = 0; i < copies; ++i) {
    PlacedLight& light = add(sources[i % sources.size()]);
    const glm::dvec3 position = place_in_view(scene.camera, strewn(i));
    light.carried = false;
    light.light.color *= fraction;
    light.position = {position.x, light.position.y, position.z};
  }
  return scene;
}

}  // namespace litfog::bench
