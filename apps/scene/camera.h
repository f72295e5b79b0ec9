// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace litfog::scene {

/// The eye. Right-handed, Y up, metres.
struct Camera {
  glm::dvec3 position{0.0, 1.6, 0.0};
  glm::dvec3 target{0.0, 1.6, -1.0};
  float field_of_view = 1.0f;  ///< vertical, radians

  friend bool operator==(const Camera&, const Camera&) = default;
};

inline constexpr double kMinFieldOfViewDeg = 1;
inline constexpr double kMaxFieldOfViewDeg = 150;

/// Whether a camera looks neither straight up nor straight down, where its picture has no up direction.
inline bool has_heading(const Camera& camera) {
  const glm::dvec3 view = camera.target - camera.position;
  return glm::length(glm::dvec2(view.x, view.z)) > 1e-4 * glm::length(view);
}
inline constexpr const char* kHeadingRule = "must not be straight above or below the position, or at it";

/// Unit vectors along a camera's axis, to the right and up in its picture.
///
/// camera  has_heading
struct CameraAxes {
  glm::dvec3 forward;
  glm::dvec3 right;
  glm::dvec3 up;
};
inline CameraAxes axes_of(const Camera& camera) {
  const glm::dvec3 forward = glm::normalize(camera.target - camera.position);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(0, 1, 0)));
  return {.forward = forward, .right = right, .up = glm::cross(right, forward)};
}

/// The transform into a camera's view: eye at the origin, x to the right, y up, -z along the camera's axis.
///
/// camera  has_heading
template <typename Real>
glm::mat<4, 4, Real> view_from_world(const Camera& camera) {
  using Vector = glm::vec<3, Real>;
  return glm::lookAt(Vector(camera.position), Vector(camera.target), Vector(0, 1, 0));
}

/// The origin of floats near a position: the world's origin within 8 km of it, where floats still resolve a millimetre,
/// else a whole number of kilometres (of 1024 m) within 900 m of the position.
inline glm::dvec3 local_origin(const glm::dvec3& position) {
  constexpr double kNear = 8192;  // metres, as is the next
  constexpr double kStep = 1024;
  if (glm::all(glm::lessThanEqual(glm::abs(position), glm::dvec3(kNear)))) return glm::dvec3(0);
  return glm::round(position / kStep) * kStep;
}

/// A camera relative to an origin.
inline Camera relative_to(const glm::dvec3& origin, Camera camera) {
  camera.position -= origin;
  camera.target -= origin;
  return camera;
}

}  // namespace litfog::scene
