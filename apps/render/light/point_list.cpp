// SPDX-License-Identifier: Apache-2.0
#include "render/light/point_list.h"

#include <algorithm>
#include <cmath>

#include "litfog/attenuation.h"
#include "litfog/cone.h"
#include "render/light/octaves.h"

namespace litfog::render {
namespace {

/// Upper bound of what a light's point adds to a pixel.
double largest_point(const SceneLights& lights, std::size_t i, const Fog& fog, const glm::dvec3& to_eye) {
  const PlacedLight& placed = lights.lights()[i];
  const Light& light = placed.light;
  const double range = glm::length(to_eye);
  if (!(range > 0)) return 0;
  constexpr double kCoreAndHalo = 1 + kHaloBrightness;
  const double cone = lights.cookie(i) ? 1 : cone_at(light.cone, glm::dot(to_eye, placed.direction) / range);
  const double through = fog_factor_at(scaled(fog, light.density_scale), range);
  const double brightness = attenuation_at(light.attenuation, range) * cone * through / kFullBrightness;
  return kCoreAndHalo * largest_component(light.color) * std::min(brightness, double(kBrightestPoint));
}

}  // namespace

PointList list_points(const SceneLights& lights, const Fog& fog, const glm::dvec3& eye, const Frustum& frustum,
                      double budget) {
  constexpr float kMargin = 1;  // metres, more than a point is ever moved towards the eye
  struct Point {
    std::int32_t light;
    double largest;
  };
  PointList list;
  std::vector<Point> points;
  Octaves octaves;
  for (std::size_t i = 0; i < lights.local_count(); ++i) {
    const glm::vec3 position(lights.lights()[i].position);
    if (!can_see(frustum, {position - kMargin, position + kMargin})) {
      ++list.outside_view;
      continue;
    }
    const double largest = largest_point(lights, i, fog, eye - lights.lights()[i].position);
    points.push_back({std::int32_t(i), largest});
    if (largest > 0) octaves.add(largest);
  }
  const double least = octaves.least_kept(budget);
  for (const Point& point : points) {
    if (point.largest < least) {
      ++list.hidden;
      continue;
    }
    list.lights.push_back(point.light);
    list.farthest = std::max(list.farthest, glm::distance(eye, lights.lights()[std::size_t(point.light)].position));
  }
  return list;
}

double point_depth_factor(double field_of_view, int height) {
  constexpr double kMaxSize = kPointRadii * kPointRadius * kMaxGlare / kPointPictureHeight;
  const double size = std::max(kMaxSize, 2.0 / height);  // in picture heights; a point has at least two pixels
  return 1 + size * std::tan(field_of_view / 2);
}

}  // namespace litfog::render
