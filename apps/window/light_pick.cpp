// SPDX-License-Identifier: Apache-2.0
#include "window/light_pick.h"

#include <cmath>

#include "render/gpu/depth.h"

namespace litfog::window {

std::optional<glm::dvec2> place_in_picture(const scene::Camera& camera, double aspect, const glm::dvec3& point) {
  const glm::dvec3 eye(camera.position);
  const auto [forward, right, up] = axes_of(camera);
  const double depth = glm::dot(point - eye, forward);
  if (!(depth > double(render::kNearPlane))) return std::nullopt;
  const double half_height = depth * std::tan(double(camera.field_of_view) / 2);
  return glm::dvec2((1 + glm::dot(point - eye, right) / (half_height * aspect)) / 2,
                    (1 - glm::dot(point - eye, up) / half_height) / 2);
}

EyeRay ray_through(const scene::Camera& camera, double aspect, const glm::dvec2& place) {
  const auto [forward, right, up] = axes_of(camera);
  const double half_height = std::tan(double(camera.field_of_view) / 2);
  const glm::dvec3 across = (2 * place.x - 1) * half_height * aspect * right + (1 - 2 * place.y) * half_height * up;
  return {.origin = camera.position, .direction = glm::normalize(forward + across)};
}

std::optional<std::size_t> light_at(const scene::Camera& camera, double aspect, std::span<const PlacedLight> lights,
                                    const glm::dvec2& place, double reach) {
  std::optional<std::size_t> best;
  double least = 0;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const auto shown = place_in_picture(camera, aspect, lights[i].position);
    if (!shown || lights[i].light.color == glm::dvec3(0)) continue;
    const double apart = glm::length((*shown - place) * glm::dvec2(aspect, 1));
    if (!(apart <= reach)) continue;
    const double badness = glm::distance(lights[i].position, glm::dvec3(camera.position)) * (1 + 4 * apart / reach);
    if (best && badness >= least) continue;
    best = i;
    least = badness;
  }
  return best;
}

}  // namespace litfog::window
