// SPDX-License-Identifier: Apache-2.0
#include "measure/reference_shadow.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "litfog/cone.h"
#include "render/shadow_caster.h"
#include "scene/light_frame.h"

namespace litfog::measure {
namespace {

constexpr double kRounding = 1e-6;    // of positions in floats, relative
constexpr double kOwnSurface = 1e-4;  // of the range: what is met that near to a position is the triangle it is on

/// The distance from a lamp to a plane in a direction; nothing if the plane is behind, or more than twice as far as the
/// point of it that the direction is near to.
std::optional<double> distance_to_plane(const glm::dvec3& point, const glm::dvec3& normal,
                                        const glm::dvec3& direction) {
  const double distance = glm::dot(normal, point) / glm::dot(normal, direction);
  if (!(distance > 0 && distance < 2 * glm::length(point))) return std::nullopt;
  return distance;
}

/// How far apart the texels of a lamp's map are, across the ray to a position. Metres.
double texel_width(const ReferenceLight& light, const glm::dvec3& from_lamp, double map_size) {
  const glm::dvec3 seen = glm::abs(scene::basis_from_world(light.placed.direction) * from_lamp);
  const double half_angle = cutoff_angle(light.placed.light.cone);
  if (half_angle > render::kWidestShadowMap) return 2 / map_size * std::max({seen.x, seen.y, seen.z});  // a cube
  return 2 / map_size * std::tan(half_angle) * seen.z;
}

/// Of rounding: where the surface is, along the ray.
double slack(const glm::dvec3& position, const glm::dvec3& from_lamp) {
  return kRounding * (glm::length(position) + glm::length(from_lamp));
}

}  // namespace

ReferenceShadows::ReferenceShadows(const render::Renderer& renderer)
    : triangles_(renderer.scene()), map_size_(renderer.settings().shadow_map_size) {}

bool ReferenceShadows::is_dark(const ReferenceLight& light, const glm::dvec3& position) const {
  const glm::dvec3 from_lamp = position - light.placed.position;
  const double range = glm::length(from_lamp);
  return triangles_.is_met(light.placed.position, from_lamp / range, render::kLampRadius,
                           range - 100 * slack(position, from_lamp));
}

bool ReferenceShadows::is_at_edge(const ReferenceLight& light, const glm::dvec3& position,
                                  const glm::dvec3& normal) const {
  const glm::dvec3& lamp = light.placed.position;
  const glm::dvec3 from_lamp = position - lamp;
  const double range = glm::length(from_lamp);
  const glm::dvec3 direction = from_lamp / range;
  const auto own = triangles_.nearest(lamp, direction, range * (1 - kOwnSurface), range * (1 + kOwnSurface));
  const glm::dvec3 plane = own ? own->normal : normal;
  const double texel = texel_width(light, from_lamp, map_size_);

  const glm::dmat3 world_from_basis = glm::transpose(scene::basis_from_world(direction));
  constexpr int kRays = 8;
  constexpr int kRings = 3;
  std::array<glm::dvec3, kRays * kRings + 1> directions;
  std::array<double, kRays * kRings + 1> distances;
  directions[0] = direction;
  distances[0] = range;
  double steepest = 0;  // metres of distance a texel
  for (int ring = 0; ring < kRings; ++ring) {
    for (int i = 0; i < kRays; ++i) {
      const double angle = 2 * std::numbers::pi * (i + 0.5 * ring) / kRays;
      const double texels = kEdgeTexels * (ring + 1) / kRings;
      const auto index = std::size_t(1 + ring * kRays + i);
      directions[index] = glm::normalize(
          from_lamp + world_from_basis * (glm::dvec3(std::cos(angle), std::sin(angle), 0) * (texels * texel)));
      const auto distance = distance_to_plane(from_lamp, plane, directions[index]);
      if (!distance) return true;  // the texel sees the surface edge on
      distances[index] = *distance;
      steepest = std::max(steepest, std::abs(*distance - range) / texels);
    }
  }
  // A map may take what is this near to the surface for it: twice the sum of its slopes over a texel of both axes.
  const double contact = slack(position, from_lamp) + 1e-5 * range;
  const double most_contact = 2 * std::numbers::sqrt2 * steepest + 2 * contact;
  int dark = 0;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const bool is_dark = triangles_.is_met(lamp, directions[i], render::kLampRadius, distances[i] - most_contact);
    if (!is_dark && triangles_.is_met(lamp, directions[i], render::kLampRadius, distances[i] - contact)) return true;
    dark += is_dark;
    if (dark != 0 && dark != int(i) + 1) return true;
  }
  return false;
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
  // Denser near the lamp, where its light is.
  const double width = std::max(offset, 0.5);
  const double first = std::asinh((low - approach) / width);
  const double last = std::asinh((high - approach) / width);
  const auto place = [&](double t) { return std::clamp(approach + width * std::sinh(t), low, high); };
  const auto is_lit = [&](double s) { return !is_dark(light, ray.origin + s * ray.direction); };
  constexpr double kFromEnds = 1e-6;  // of a step: the ends may lie on a surface
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
