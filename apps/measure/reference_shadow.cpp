// SPDX-License-Identifier: Apache-2.0
#include "measure/reference_shadow.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "litfog/cone.h"
#include "render/shadow/shadow_caster.h"
#include "scene/light_frame.h"

namespace litfog::measure {
namespace {

constexpr double kRounding = 1e-6;    // relative rounding of positions in floats
constexpr double kOwnSurface = 1e-4;  // fraction of the range; nearer hits are the position's own triangle
constexpr double kEndless = std::numeric_limits<double>::infinity();

/// The distance from a lamp to a plane along a direction. Nothing if the plane is behind the lamp, or more than twice
/// as far as its given point.
std::optional<double> distance_to_plane(const glm::dvec3& point, const glm::dvec3& normal,
                                        const glm::dvec3& direction) {
  const double distance = glm::dot(normal, point) / glm::dot(normal, direction);
  if (!(distance > 0 && distance < 2 * glm::length(point))) return std::nullopt;
  return distance;
}

/// The distance between texels of a lamp's map, across the ray to a position. Metres.
double texel_width(const ReferenceLight& light, const glm::dvec3& from_lamp, double map_size) {
  const glm::dvec3 seen = glm::abs(scene::basis_from_world(light.placed.direction) * from_lamp);
  const double half_angle = cutoff_angle(light.placed.light.cone);
  if (half_angle > render::kWidestShadowMap) return 2 / map_size * std::max({seen.x, seen.y, seen.z});  // a cube
  return 2 / map_size * std::tan(half_angle) * seen.z;
}

/// Rounding of the surface's position along the ray.
double slack(const glm::dvec3& position, const glm::dvec3& from_lamp) {
  return kRounding * (glm::length(position) + glm::length(from_lamp));
}

}  // namespace

ReferenceShadows::ReferenceShadows(const render::Renderer& renderer)
    : triangles_(renderer.scene(), renderer.origin()),
      to_moon_(glm::normalize(glm::dvec3(renderer.scene().environment.moon_direction))),
      moon_maps_(renderer.shadows()->moon_maps()),
      map_size_(renderer.settings().shadow_map_size) {}

bool ReferenceShadows::is_dark(const ReferenceLight& light, const glm::dvec3& position) const {
  const glm::dvec3 from_lamp = position - light.placed.position;
  const double range = glm::length(from_lamp);
  return triangles_.is_met(light.placed.position, from_lamp / range, render::kLampRadius,
                           range - 100 * slack(position, from_lamp));
}

bool ReferenceShadows::is_dark_to_moon(const glm::dvec3& position) const {
  return triangles_.is_met(position, to_moon_, 100 * slack(position, glm::dvec3(0)), kEndless);
}

bool ReferenceShadows::is_met(const Probe& probe, double before_plane) const {
  return triangles_.is_met(probe.origin, probe.direction, probe.first, probe.distance - before_plane);
}

/// The normal of the triangle where a probe ends, or else the surface's.
glm::dvec3 ReferenceShadows::plane_at(const Probe& probe, const glm::dvec3& normal) const {
  const double slack = kOwnSurface * probe.distance;
  const auto own = triangles_.nearest(probe.origin, probe.direction, probe.distance - slack, probe.distance + slack);
  return own ? own->normal : normal;
}

template <typename ProbeAt>
bool ReferenceShadows::is_at_edge(const ProbeAt& probe_at, double contact) const {
  constexpr int kRays = 8;
  constexpr int kRings = 3;
  std::vector<Probe> probes{*probe_at(glm::dvec2(0))};
  double steepest = 0;  // metres of distance a texel
  for (int ring = 0; ring < kRings; ++ring) {
    for (int i = 0; i < kRays; ++i) {
      const double angle = 2 * std::numbers::pi * (i + 0.5 * ring) / kRays;
      const double texels = kEdgeTexels * (ring + 1) / kRings;
      const std::optional<Probe> probe = probe_at(texels * glm::dvec2(std::cos(angle), std::sin(angle)));
      if (!probe) return true;  // the texel sees the surface edge-on
      probes.push_back(*probe);
      steepest = std::max(steepest, std::abs(probe->distance - probes[0].distance) / texels);
    }
  }
  // A map may confuse what is this near with the surface: twice the sum of its slopes over a texel of both axes.
  const double most_contact = 2 * std::numbers::sqrt2 * steepest + 2 * contact;
  const bool is_dark = is_met(probes[0], most_contact);
  return std::ranges::any_of(probes, [&](const Probe& probe) {
    return is_met(probe, most_contact) != is_dark || (!is_dark && is_met(probe, contact));
  });
}

bool ReferenceShadows::is_at_edge(const ReferenceLight& light, const glm::dvec3& position,
                                  const glm::dvec3& normal) const {
  const glm::dvec3& lamp = light.placed.position;
  const glm::dvec3 from_lamp = position - lamp;
  const double range = glm::length(from_lamp);
  const glm::dvec3 direction = from_lamp / range;
  const glm::dvec3 plane = plane_at({lamp, direction, 0, range}, normal);
  const double texel = texel_width(light, from_lamp, map_size_);
  const glm::dmat3 world_from_basis = glm::transpose(scene::basis_from_world(direction));
  const auto probe_at = [&](const glm::dvec2& texels) -> std::optional<Probe> {
    const glm::dvec3 beside = glm::normalize(from_lamp + world_from_basis * glm::dvec3(texels * texel, 0));
    const auto distance = distance_to_plane(from_lamp, plane, beside);
    if (!distance) return std::nullopt;
    return Probe{lamp, beside, render::kLampRadius, *distance};
  };
  return is_at_edge(probe_at, slack(position, from_lamp) + 1e-5 * range);
}

bool ReferenceShadows::is_at_moon_edge(const glm::dvec3& position, const glm::dvec3& normal) const {
  const auto map = std::ranges::find_if(moon_maps_, [&](const render::MoonMap& each) {
    const glm::dvec3 place = glm::abs(each.frame_from_world * (position - each.position));
    return std::max(place.x, place.y) < each.half_size * (1 - 4 / map_size_);
  });
  if (map == moon_maps_.end()) return false;
  const double texel = 2 * map->half_size / map_size_;
  const glm::dmat3 world_from_frame = glm::transpose(map->frame_from_world);
  const double range = glm::dot(map->position - position, to_moon_);
  const glm::dvec3 plane = plane_at({position + range * to_moon_, -to_moon_, 0, range}, normal);
  const double facing = glm::dot(plane, to_moon_);
  const auto probe_at = [&](const glm::dvec2& texels) -> std::optional<Probe> {
    const glm::dvec3 across = world_from_frame * glm::dvec3(texels * texel, 0);
    const double distance = range + glm::dot(plane, across) / facing;
    if (!std::isfinite(distance)) return std::nullopt;
    return Probe{position + across + range * to_moon_, -to_moon_, 0, distance};
  };
  return is_at_edge(probe_at, slack(position, map->position) + 0.02 * texel);
}

std::vector<std::pair<double, double>> ReferenceShadows::lit_stretches(const ReferenceLight& light,
                                                                       const EyeRay& ray) const {
  const double approach = glm::dot(light.placed.position - ray.origin, ray.direction);
  const double offset = glm::distance(ray.origin + approach * ray.direction, light.placed.position);
  const double chord = std::sqrt(std::max(light.extent * light.extent - offset * offset, 0.0));
  const double low = std::max(0.0, approach - chord);
  const double high = std::min(ray.length, approach + chord);
  std::vector<std::pair<double, double>> stretches;
  if (!(high > low)) return stretches;
  // Denser near the lamp, where the light is.
  const double width = std::max(offset, 0.5);
  const double first = std::asinh((low - approach) / width);
  const double last = std::asinh((high - approach) / width);
  const auto place = [&](double t) { return std::clamp(approach + width * std::sinh(t), low, high); };
  const auto is_lit = [&](double s) { return !is_dark(light, ray.origin + s * ray.direction); };
  constexpr double kFromEnds = 1e-6;  // fraction of a step, because the ends may lie on a surface
  double before = first + kFromEnds * (last - first) / kStretchSteps;
  bool was_lit = is_lit(place(before));
  double start = low;
  for (int i = 1; i <= kStretchSteps; ++i) {
    const double t = first + (last - first) * (i < kStretchSteps ? i : i - kFromEnds) / kStretchSteps;
    const bool is_now = is_lit(place(t));
    if (is_now != was_lit) {
      double in = before;
      double out = t;
      for (int k = 0; k < 24; ++k) {
        const double middle = 0.5 * (in + out);
        (is_lit(place(middle)) == was_lit ? in : out) = middle;
      }
      if (was_lit) stretches.emplace_back(start, place(in));
      start = place(in);
      was_lit = is_now;
    }
    before = t;
  }
  if (was_lit) stretches.emplace_back(start, high);
  return stretches;
}

}  // namespace litfog::measure
