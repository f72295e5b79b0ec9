// SPDX-License-Identifier: Apache-2.0
#include "window/camera_motion.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

namespace litfog::window {
namespace {

constexpr double kNearest = 0.1;  // metres
constexpr double kFarthest = 1e5;
constexpr double kClearance = 0.15;  // metres; more than from the eye to the near plane's corners

/// A direction turned right and up, no steeper than kSteepest.
Direction tilted(const Direction& from, double right, double up) {
  return {from.heading + right, std::clamp(from.pitch + up, -kSteepest, kSteepest)};
}

glm::dvec3 view(const scene::Camera& camera) { return camera.target - camera.position; }

/// Whether a surface is so near that the near plane clips it.
bool is_near(const glm::dvec3& at, const measure::TriangleTree& surfaces) {
  for (const double side : {-1.0, 1.0}) {
    for (int axis = 0; axis < 3; ++axis) {
      glm::dvec3 direction(0);
      direction[axis] = side;
      if (surfaces.is_met(at, direction, 0, kClearance)) return true;
    }
  }
  return false;
}

}  // namespace

Direction direction_of(const glm::dvec3& vector) {
  return {std::atan2(vector.x, -vector.z), std::atan2(vector.y, std::hypot(vector.x, vector.z))};
}

glm::dvec3 unit_vector(const Direction& direction) {
  return {std::cos(direction.pitch) * std::sin(direction.heading), std::sin(direction.pitch),
          -std::cos(direction.pitch) * std::cos(direction.heading)};
}

void look(scene::Camera& camera, double right, double up) {
  const Direction seen = direction_of(view(camera));
  camera.target = camera.position + unit_vector(tilted(seen, right, up)) * target_distance(camera);
}

void fly(scene::Camera& camera, double right, double up, double ahead) {
  const scene::CameraAxes axes = axes_of(camera);
  const glm::dvec3 step = right * axes.right + up * glm::dvec3(0, 1, 0) + ahead * axes.forward;
  camera.position = camera.position + step;
  camera.target = camera.target + step;
}

void orbit(scene::Camera& camera, const glm::dvec3& pivot, double right, double up) {
  const auto frame = [](const scene::Camera& of) {
    const scene::CameraAxes axes = axes_of(of);
    return glm::dmat3(axes.right, axes.up, -axes.forward);
  };
  scene::Camera turned = camera;
  look(turned, -right, -up);
  const glm::dvec3 from_pivot = frame(turned) * (glm::transpose(frame(camera)) * (camera.position - pivot));
  camera.position = pivot + from_pivot;
  camera.target = camera.position + view(turned);
}

void approach(scene::Camera& camera, const glm::dvec3& pivot, double factor) {
  const glm::dvec3 way = pivot - camera.position;
  const double distance = glm::length(way);
  if (!(distance > 0)) return;
  const double left = std::clamp(distance * factor, kNearest, kFarthest);
  const glm::dvec3 forward = axes_of(camera).forward;
  camera.position += way * (1 - left / distance);
  camera.target = camera.position + left * forward;
}

void stay_before_surfaces(scene::Camera& camera, const scene::Camera& before, const measure::TriangleTree& surfaces) {
  const glm::dvec3 way = camera.position - before.position;
  const double length = glm::length(way);
  if (!(length > 0)) return;
  const bool goes_through = surfaces.is_met(before.position, way / length, 0, length + kClearance);
  if (goes_through || (is_near(camera.position, surfaces) && !is_near(before.position, surfaces))) camera = before;
}

double target_distance(const scene::Camera& camera) { return glm::length(view(camera)); }

}  // namespace litfog::window
