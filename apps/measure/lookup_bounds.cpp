// SPDX-License-Identifier: Apache-2.0
#include "measure/path_model.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/light/light_map.h"

namespace litfog::measure {
namespace {

/// Whether a direction is within a texel of an edge between two faces of a light's cookie.
bool is_at_seam(const ReferenceLight& light, const glm::dvec3& direction) {
  glm::dvec3 a = glm::abs(light.cookie_from_world * direction);
  std::sort(&a.x, &a.x + 3);
  return (a.z - a.y) / a.z < 2.0 / light.cookie->size;
}

}  // namespace

LookupBounds::Interval LookupBounds::surface_color(const SurfacePoint& point) const {
  const glm::dvec3 without_lamps = model_.without_lamps(point);
  Interval color{without_lamps, without_lamps};
  for (const ReferenceLight& light : model_.lights()) {
    // Texels around a position: within a cell of the 3-D map, or a cell of each 2-D map.
    const double around = 3 * texel_ * light.extent;
    const auto ray = ray_within(light.extent + around, light, point.position);
    if (!ray || model_.is_in_shadow(point, light)) continue;
    const auto [dimmest, brightest] = emitted(light, ray->direction);
    const glm::dvec3 reflected = light.placed.light.color * model_.reflectance(point, -ray->direction);
    color.least += reflected * dimmest * model_.falloff(light, point.position.y, ray->range + around);
    color.most += reflected * brightest * model_.falloff(light, point.position.y, std::max(ray->range - around, 0.0));
  }
  return color;
}

LookupBounds::Interval LookupBounds::fog_color(const glm::dvec3& position) const {
  Interval color{model_.atmosphere().ambient_fog_color, model_.atmosphere().ambient_fog_color};
  for (const ReferenceLight& light : model_.lights()) {
    const auto ray = model_.lights_fog(light) ? ray_within(kAnyRange, light, position) : std::nullopt;
    if (!ray) continue;
    const auto [dimmest, brightest] = emitted(light, ray->direction);
    color.least += light.placed.light.color * (dimmest * light.fog_intensity);
    color.most += light.placed.light.color * (brightest * light.fog_intensity);
  }
  return color;
}

LookupBounds::Fractions LookupBounds::emitted(const ReferenceLight& light, const glm::dvec3& direction) const {
  if (light.cookie) {  // the cube map holds the cookie's own texels, but filters them across face edges
    if (is_at_seam(light, direction)) return {0, 1};
    const double exact = light.emitted(direction);
    return {exact, exact};
  }
  // The largest angle that a texel's diagonal spans. A face spans the cone if the map is scaled (cone_map_scale), else
  // a quarter of the circle.
  const double turn =
      std::numbers::sqrt2 / std::min(render::cone_map_scale(light.placed.light.cone, cone_maps_), 1.0) * texel_;
  const double angle = std::acos(std::clamp(glm::dot(light.placed.direction, direction), -1.0, 1.0));
  return {cone_at(light.placed.light.cone, std::cos(std::min(angle + turn, std::numbers::pi))),
          cone_at(light.placed.light.cone, std::cos(std::max(angle - turn, 0.0)))};
}

}  // namespace litfog::measure
