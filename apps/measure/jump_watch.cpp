// SPDX-License-Identifier: Apache-2.0
#include "measure/path_model.h"

#include <algorithm>
#include <cmath>

#include "measure/night_sky.h"
#include "render/light/hidden_range.h"

namespace litfog::measure {
namespace {

constexpr double kUnit = 0x1p-22;             // some units in the last place of a float near 1
constexpr double kHorizonRounding = 0x1p-20;  // rounding of a direction's height, interpolated over the picture
constexpr double kMaxRounding = 5e-4;         // fraction of an extent, for lights kilometres from the origin

bool is_seen(const glm::dvec3& jump) {
  constexpr double kLeast = 1e-4;  // a third of a step on the display at black
  return render::largest_component(jump) > kLeast;
}

/// Relative rounding of the vector from a light to a position, both in floats. It is large if the vector is short and
/// both are far from the origin.
double rounding_of(const ReferenceLight& light, const glm::dvec3& position, double range) {
  const glm::dvec3 largest = glm::max(glm::abs(light.placed.position), glm::abs(position));
  return kUnit * (1 + render::largest_component(largest) / range);
}

double cos_cutoff(const ReferenceLight& light) { return std::cos(cutoff_angle(light.placed.light.cone)); }

bool is_at_cone_edge(const ReferenceLight& light, const LightRay& ray, double rounding) {
  return cutoff_level(light.placed.light.cone) > 0 &&
         std::abs(glm::dot(light.placed.direction, ray.direction) - cos_cutoff(light)) < rounding;
}

/// The cone's value just within its edge.
double emitted_at_edge(const ReferenceLight& light, double rounding) {
  return cone_at(light.placed.light.cone, std::min(cos_cutoff(light) + rounding, 1.0));
}

}  // namespace

bool JumpWatch::is_at_jump(const SurfacePoint& point) const {
  const scene::Environment& environment = model_.environment();
  const glm::dvec3 moon = environment.moon_direction;
  if (model_.path().evaluation != render::Evaluation::lookup && std::abs(glm::dot(point.normal, moon)) < kUnit &&
      is_seen(glm::dvec3(environment.moon_color) * model_.highlight(point, moon))) {
    return true;
  }
  if (is_seen(model_.moonlight(point)) && model_.is_at_moon_shadow_edge(point)) return true;
  return std::ranges::any_of(model_.lights(), [&](const ReferenceLight& light) {
    const auto ray = ray_within(light.extent * (1 + kMaxRounding), light, point.position);
    return ray && (is_at_jump(point, light, *ray) || is_at_shadow_edge(point, light, *ray));
  });
}

bool JumpWatch::is_at_jump(const SurfacePoint& point, const ReferenceLight& light, const LightRay& ray) const {
  const glm::dvec3 to_light = -ray.direction;
  const double rounding = rounding_of(light, point.position, ray.range);
  const bool is_just_turned_away = std::abs(glm::dot(point.normal, to_light)) < rounding;
  const bool is_at_extent = std::abs(ray.range - light.extent) < rounding * ray.range;
  const bool is_at_edge = is_at_cone_edge(light, ray, rounding);
  if (!is_just_turned_away && !is_at_extent && !is_at_edge) return false;
  const glm::dvec3 on_axis =
      light.placed.light.color * model_.falloff(light, point.position.y, std::min(ray.range, light.extent));
  const glm::dvec3 arriving = on_axis * light.emitted(ray.direction);
  const glm::dvec3 reflectance = model_.reflectance(point, to_light);
  return (is_just_turned_away && is_seen(arriving * model_.highlight(point, to_light))) ||
         (is_at_extent && is_seen(arriving * reflectance)) ||
         (is_at_edge && is_seen(on_axis * emitted_at_edge(light, rounding) * reflectance));
}

bool JumpWatch::is_at_shadow_edge(const SurfacePoint& point, const ReferenceLight& light, const LightRay& ray) const {
  const glm::dvec3 arriving =
      light.placed.light.color * model_.falloff(light, point.position.y, ray.range) * light.emitted(ray.direction);
  return is_seen(arriving * model_.reflectance(point, -ray.direction)) && model_.is_at_shadow_edge(point, light);
}

bool JumpWatch::is_at_jump(const Veil& veil, const glm::dvec3& position) const {
  if (veil.opacity <= 0) return false;
  return std::ranges::any_of(model_.lights(), [&](const ReferenceLight& light) {
    if (!model_.lights_fog(light)) return false;
    const auto ray = ray_within(kAnyRange, light, position);
    if (!ray) return false;
    const double rounding = rounding_of(light, position, ray->range);
    return is_at_cone_edge(light, *ray, rounding) &&
           is_seen(light.placed.light.color * emitted_at_edge(light, rounding) * light.fog_intensity * veil.opacity);
  });
}

bool JumpWatch::is_at_fog_horizon(double fog_above_eye, const glm::dvec3& direction) const {
  const auto opacity = [&](double rise) {
    const glm::dvec3 near(direction.x, direction.y + rise, direction.z);
    return model_.opacity_before(model_.eye() + near * fog_before_sky(fog_above_eye, near));
  };
  return is_seen(glm::dvec3(opacity(-kHorizonRounding) - opacity(kHorizonRounding)));
}

}  // namespace litfog::measure
