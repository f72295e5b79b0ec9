// SPDX-License-Identifier: Apache-2.0
#include "window/camera_motion.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

namespace litfog::window {
namespace {

constexpr double kNearest = 0.1;  // metres
constexpr double kFarthest = 1e5;

/// A direction by its heading to the right of -Z and its pitch.
struct Direction {
  double heading;
  double pitch;
};

Direction direction_of(const glm::dvec3& vector) {
  return {std::atan2(vector.x, -vector.z), std::atan2(vector.y, std::hypot(vector.x, vector.z))};
}

glm::dvec3 unit_vector(const Direction& direction) {
  const double pitch = std::clamp(direction.pitch, -kSteepest, kSteepest);
  return {std::cos(pitch) * std::sin(direction.heading), std::sin(pitch),
          -std::cos(pitch) * std::cos(direction.heading)};
}

glm::dvec3 view(const scene::Camera& camera) { return camera.target - camera.position; }

}  // namespace

void look(scene::Camera& camera, double right, double up) {
  const Direction seen = direction_of(view(camera));
  camera.target = camera.position + unit_vector({seen.heading + right, seen.pitch + up}) * target_distance(camera);
}

void fly(scene::Camera& camera, double right, double up, double ahead) {
  const scene::CameraAxes axes = axes_of(camera);
  const glm::dvec3 step = right * axes.right + up * glm::dvec3(0, 1, 0) + ahead * axes.forward;
  camera.position = camera.position + step;
  camera.target = camera.target + step;
}

void orbit(scene::Camera& camera, double right, double up) {
  const Direction from_eye = direction_of(view(camera));
  camera.position =
      camera.target - unit_vector({from_eye.heading - right, from_eye.pitch - up}) * target_distance(camera);
}

void approach(scene::Camera& camera, double factor) {
  const double distance = target_distance(camera);
  camera.position = camera.target - view(camera) * (std::clamp(distance * factor, kNearest, kFarthest) / distance);
}

double target_distance(const scene::Camera& camera) { return glm::length(view(camera)); }

}  // namespace litfog::window
