// SPDX-License-Identifier: Apache-2.0
#include "measure/night_sky.h"

#include <algorithm>
#include <cmath>

#include "render/plan/fog_top.h"

namespace litfog::measure {
namespace {

/// Three numbers in [0, 1) for a cell: pcg3d (Jarzynski and Olano 2020, "Hash Functions for GPU Rendering").
glm::dvec3 hash(const glm::ivec3& cell) {
  glm::uvec3 v = glm::uvec3(cell) * 1664525u + 1013904223u;
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  v ^= v >> 16u;
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  return glm::dvec3(v >> 8u) / 16777216.0;
}

/// At most one star in each cell of a grid on the direction's cube.
double star(const glm::dvec3& direction) {
  const glm::dvec3 a = glm::abs(direction);
  const glm::ivec3 cell(glm::round(direction / std::max({a.x, a.y, a.z}) * 90.0));
  const double presence = hash(cell).x;
  if (presence < 0.94) return 0;
  const glm::dvec3 centre = glm::normalize(glm::dvec3(cell) + 0.4 * hash(cell + 1000) - 0.2);
  const double angle = glm::distance(centre, direction);
  const double size = (presence - 0.94) / 0.06;
  return size * size * std::exp(-angle * angle * 3.0e6);
}

}  // namespace

glm::dvec3 night_sky(const scene::Environment& environment, const glm::dvec3& direction) {
  const double height = std::max(direction.y, 0.0);
  glm::dvec3 sky =
      glm::mix(glm::dvec3(environment.sky_horizon), glm::dvec3(environment.sky_zenith), 1 - std::pow(1 - height, 4));
  sky += double(environment.star_brightness) * star(direction) * glm::smoothstep(0.0, 0.25, height);
  if (environment.has_moon()) {
    const double off = glm::distance(direction, glm::dvec3(environment.moon_direction));
    const double disc = 1 - glm::smoothstep(0.0045, 0.0053, off);
    sky += glm::normalize(glm::dvec3(environment.moon_color)) * (disc + 0.05 * std::exp(-off * 40));
  }
  return sky;
}

double fog_before_sky(double fog_above_eye, const glm::dvec3& direction) {
  constexpr double kEndless = render::kSkyDistance;
  if (direction.y > 0) return std::min(std::max(fog_above_eye, 0.0) / direction.y, kEndless);
  return direction.y == 0 && fog_above_eye < 0 ? 0 : kEndless;
}

}  // namespace litfog::measure
