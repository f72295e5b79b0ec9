// SPDX-License-Identifier: Apache-2.0
#include "measure/reference_light.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "litfog/formulas.h"

namespace litfog::measure {
namespace {

/// The cosine of the smallest angle between a cone's axis and the directions from its light to a segment of a ray,
/// rounded up.
///
/// first, last  ends of the segment, metres from the ray's origin
double largest_cosine(const PlacedLight& light, const EyeRay& ray, double first, double last) {
  constexpr double kRounding = 1e-9;
  const glm::dvec3 to_light = light.position - ray.origin;
  const auto cosine_at = [&](double along) {
    if (std::isinf(along)) return glm::dot(ray.direction, light.direction);
    const glm::dvec3 from_light = along * ray.direction - to_light;
    const double range = glm::length(from_light);
    return range > 0 ? glm::dot(from_light, light.direction) / range : 1;
  };
  double largest = std::max(cosine_at(first), cosine_at(last));
  // The angle has one extremum along the line; it is the smallest where the light's closest approach is before it.
  const double approach = glm::dot(to_light, ray.direction);
  const glm::dvec3 offset = approach * ray.direction - to_light;
  const double axis_offset = glm::dot(offset, light.direction);
  if (axis_offset > 0) {
    const double extremum =
        approach + glm::dot(ray.direction, light.direction) * glm::dot(offset, offset) / axis_offset;
    largest = std::max(largest, cosine_at(std::clamp(extremum, first, last)));
  }
  return std::min(largest + kRounding, 1.0);
}

/// The largest -f'(s) f(r), 1/m, where r >= |L - s| and L is the distance from the eye to the light. In exp fog the
/// density is at most the thickest fog's, and the optical depth of both legs at least that of L in the thinnest fog. In
/// exp2 fog it is the largest 2 d x e^(-x^2 - (d L - x)^2) with x = d s, where 4 x^2 = 1 + 2 d L x.
double largest_weight(const Fog& thinnest, const Fog& thickest, double eye_range) {
  const double depth = thinnest.density * eye_range;
  if (thickest.mode == FogMode::exp) return thickest.density * std::exp(-depth);
  const double x = (depth + std::sqrt(depth * depth + 4)) / 4;
  return thickest.density * 2 * x * std::exp(-x * x - (depth - x) * (depth - x));
}

}  // namespace

double airlight_bound(const ReferenceLight& light, const EyeRay& ray, const Atmosphere& atmosphere) {
  const double density_scale = light.placed.light.density_scale;
  const Fog thinnest = scaled(atmosphere.thinnest_fog(), density_scale);
  const Fog thickest = scaled(atmosphere.thickest_fog(), density_scale);
  const glm::dvec3 to_light = light.placed.position - ray.origin;
  const double approach = glm::dot(to_light, ray.direction);
  const double nearest = glm::distance(to_light, std::clamp(approach, 0.0, ray.length) * ray.direction);
  if (!(nearest < light.fog_extent)) return 0;
  const Attenuation& attenuation = light.placed.light.attenuation;
  const double brightest = attenuation_at(attenuation, nearest);
  const double eye_range = glm::length(to_light);
  if (std::isinf(thinnest.density) && eye_range > 0) return 0;  // the fog at the eye hides everything
  const double offset = glm::distance(to_light, approach * ray.direction);
  const double half_chord = std::sqrt(std::max(light.fog_extent * light.fog_extent - offset * offset, 0.0));
  const double first = std::clamp(approach - half_chord, 0.0, ray.length);
  const double last = std::clamp(approach + half_chord, first, ray.length);
  const double factor =
      cone_at(light.placed.light.cone, largest_cosine(light.placed, ray, first, last)) *
      largest_phase(atmosphere.phase, -1, eye_range > 0 ? std::clamp(approach / eye_range, -1.0, 1.0) : 1);
  if (std::isinf(thickest.density)) return factor * brightest;
  const double denominator =
      formulas::denominator(offset, attenuation.constant, attenuation.linear, attenuation.quadratic);
  const double integral =
      std::min(brightest * (last - first), std::numbers::pi / std::sqrt(attenuation.quadratic * denominator));
  return factor * std::min(brightest, largest_weight(thinnest, thickest, eye_range) * integral);
}

}  // namespace litfog::measure
