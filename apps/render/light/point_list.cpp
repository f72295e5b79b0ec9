// SPDX-License-Identifier: Apache-2.0
#include "render/light/point_list.h"

#include "litfog/attenuation.h"
#include "litfog/color_temperature.h"
#include "litfog/cone.h"

namespace litfog::render {
namespace {

/// Upper bound of the light that a light's point adds to a pixel.
double largest_point(const SceneLights& lights, std::size_t i, const Atmosphere& atmosphere, FogLighting fog_lighting,
                     const PointView& view) {
  const PlacedLight& placed = lights.lights()[i];
  const Light& light = placed.light;
  const glm::dvec3 to_eye = view.eye - placed.position;
  const double range = glm::length(to_eye);
  if (!(range > 0)) return 0;
  const double cone = lights.cookie(i) ? 1 : cone_at(light.cone, glm::dot(to_eye, placed.direction) / range);
  const Fog fog = atmosphere.fog_between(placed.position.y, view.eye.y);
  const double through = fog_factor_at(scaled(fog, light.density_scale), range);
  const double arriving = attenuation_at(light.attenuation, range) * cone * through;
  if (fog_lighting == FogLighting::airlight) {
    if (luminance(light.color) * arriving < view.least_seen) return 0;
    const double cosine = std::max(-glm::dot(to_eye, view.forward) / range, 0.01);
    const double pixel = std::pow(view.pixels_per_radian, -2) * std::pow(cosine, 3);  // its solid angle
    return largest_component(light.color) * arriving / (pixel * (1 + 0.2 * double(kDiscEdge * kDiscEdge)));
  }
  constexpr double kCoreAndHalo = 1 + kHaloBrightness;
  return kCoreAndHalo * largest_component(light.color) * std::min(arriving / kFullBrightness, double(kBrightestPoint));
}

/// A surface hides no part of a point that is nearer by this factor. A whole point is drawn at the depth of its centre:
/// the range times the cosine between its ray and the camera's axis. Within a point of half size h, as a tangent, the
/// cosine changes by a factor of at most 1 + h.
///
/// size  the point's, in picture heights
double depth_factor(double size, const PointView& view) {
  const double least = 2.0 / view.height;  // a point has at least two pixels
  return 1 + std::max(size, least) * view.height / (2 * view.pixels_per_radian);
}

/// A point's size in picture heights.
double point_size(FogLighting fog_lighting, double source_radius, double range, const PointView& view) {
  if (fog_lighting == FogLighting::peak) return kPointRadii * kPointRadius * kMaxGlare / kPointPictureHeight;
  constexpr double kWidestPixels = 6;  // the smallest disc with its edge, plus a pixel
  // Seen from the picture's corner a disc spans up to 1 / cosine^1.5 times as many pixels; 4 is for 66 degrees.
  return (kWidestPixels + 4 * 2 * source_radius / range * view.pixels_per_radian) / view.height;
}

}  // namespace

PointList list_points(const SceneLights& lights, const Atmosphere& atmosphere, FogLighting fog_lighting,
                      const PointView& view, double budget) {
  constexpr float kMargin = 1;  // metres; more than any point is moved towards the eye
  struct Point {
    std::int32_t light;
    double largest;
  };
  PointList list;
  std::vector<Point> points;
  Octaves octaves;
  for (std::size_t i = 0; i < lights.local_count(); ++i) {
    const glm::vec3 position(lights.lights()[i].position);
    const float margin = kMargin + float(lights.source_radius(i));
    if (!can_see(view.frustum, {position - margin, position + margin})) {
      ++list.outside_view;
      continue;
    }
    const double largest = largest_point(lights, i, atmosphere, fog_lighting, view);
    points.push_back({std::int32_t(i), largest});
    if (largest > 0) octaves.add(largest);
  }
  const double least = octaves.least_kept(budget);
  for (const Point& point : points) {
    if (point.largest < least || point.largest == 0) {
      ++list.hidden;
      continue;
    }
    list.lights.push_back(point.light);
    const auto light = std::size_t(point.light);
    const double range = glm::distance(view.eye, lights.lights()[light].position);
    const double size = point_size(fog_lighting, lights.source_radius(light), range, view);
    list.hidden_by = std::max(list.hidden_by, range * depth_factor(size, view));
  }
  return list;
}

}  // namespace litfog::render
