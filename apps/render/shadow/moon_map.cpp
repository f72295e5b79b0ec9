// SPDX-License-Identifier: Apache-2.0
#include "render/shadow/moon_map.h"

#include <algorithm>
#include <cmath>

#include "scene/light_frame.h"

namespace litfog::render {
namespace {

struct Ball {
  double distance;  // from the camera to the centre, along the camera's axis
  double radius;
};

/// The smallest ball around the camera and its view volume up to a distance along its axis.
///
/// slope  tangent of the angle between the axis and the picture's corners
Ball ball_around(double distance, double slope) {
  const double middle = 0.5 * distance * (1 + slope * slope);  // equally far from the camera and from the corners
  return middle < distance ? Ball{middle, middle} : Ball{distance, distance * slope};
}

struct Box {
  glm::dvec3 middle, half;
};

/// The bounds of a box in a rotated frame.
Box turned(const scene::Bounds& box, const glm::dmat3& frame_from_world) {
  const glm::dvec3 low = box.low;
  const glm::dvec3 high = box.high;
  glm::dmat3 spread = frame_from_world;
  for (int column = 0; column < 3; ++column) spread[column] = glm::abs(spread[column]);
  return {frame_from_world * (0.5 * (low + high)), spread * (0.5 * (high - low))};
}

}  // namespace

std::vector<MoonMap> fit_moon_maps(const scene::Environment& environment, const scene::Camera& camera,
                                   const scene::Bounds& bounds, double aspect, int map_size) {
  if (!environment.has_moon()) return {};
  constexpr double kNextDistance = 4;
  const glm::dvec3& eye = camera.position;
  const glm::dvec3 forward = axes_of(camera).forward;
  const double slope = std::tan(0.5 * double(camera.field_of_view)) * std::hypot(1.0, aspect);
  const glm::dmat3 frame_from_world = scene::basis_from_world(-glm::normalize(glm::dvec3(environment.moon_direction)));
  const Box all = turned(bounds, frame_from_world);
  const double margin = 1 + 0.001 * all.half.z;  // metres
  const double texels = 1 + 4.0 / map_size;      // the taps around a texel at the rim

  std::vector<MoonMap> maps(kMoonMaps);
  double distance = std::max(farthest_distance(eye, bounds), 1.0);
  for (int i = kMoonMaps - 1; i >= 0; --i) {
    const Ball ball = ball_around(distance, slope);
    glm::dvec3 position = frame_from_world * (eye + ball.distance * forward);
    position.z = all.middle.z + all.half.z + margin;
    maps[std::size_t(i)] = {.position = glm::transpose(frame_from_world) * position,
                            .frame_from_world = frame_from_world,
                            .half_size = texels * ball.radius,
                            .reach = 2 * (all.half.z + margin)};
    distance /= kNextDistance;
  }
  return maps;
}

bool can_cast(const scene::Bounds& box, const MoonMap& map) {
  const Box seen = turned(box, map.frame_from_world);
  const glm::dvec3 away = glm::abs(seen.middle - map.frame_from_world * map.position) - seen.half;
  return away.x <= map.half_size && away.y <= map.half_size;
}

}  // namespace litfog::render
