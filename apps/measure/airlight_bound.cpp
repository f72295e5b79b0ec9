// SPDX-License-Identifier: Apache-2.0
#include "measure/airlight_bound.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "litfog/formulas.h"

namespace litfog::measure {
namespace {

/// Bound of -f'(s) f(r) along a ray, 1/m.
double largest_weight(const Fog& fog, double eye_range) {
  const double depth = fog.density * eye_range;
  if (fog.mode == FogMode::exp) return fog.density * std::exp(-depth);
  return 2 * std::exp(-0.5) * fog.density * std::exp(-depth * depth / 3);
}

/// Henyey and Greenstein's phase function straight ahead, or straight back where that is brighter, over its isotropic
/// value.
double largest_phase(double asymmetry) {
  const double g = std::abs(asymmetry);
  return (1 + g) / ((1 - g) * (1 - g));
}

}  // namespace

double airlight_bound(const ReferenceLight& light, const EyeRay& ray, const Scattering& scattering) {
  const glm::dvec3 to_light = light.placed.position - ray.origin;
  const double approach = glm::dot(to_light, ray.direction);
  const double nearest = glm::distance(to_light, std::clamp(approach, 0.0, ray.length) * ray.direction);
  if (!(nearest < light.extent)) return 0;
  const Attenuation& attenuation = light.placed.light.attenuation;
  const double brightest = attenuation_at(attenuation, nearest);
  const double eye_range = glm::length(to_light);
  const double phase = largest_phase(scattering.asymmetry);
  if (std::isinf(light.fog.density)) return eye_range > 0 ? 0 : brightest * phase;  // all is scattered in the eye
  const double offset = glm::distance(to_light, approach * ray.direction);
  const double half_chord = std::sqrt(std::max(light.extent * light.extent - offset * offset, 0.0));
  const double lit = std::min(ray.length, approach + half_chord) - std::max(0.0, approach - half_chord);
  const double denominator =
      formulas::denominator(offset, attenuation.constant, attenuation.linear, attenuation.quadratic);
  const double integral = std::min(brightest * lit, std::numbers::pi / std::sqrt(attenuation.quadratic * denominator));
  return phase * std::min(brightest, largest_weight(light.fog, eye_range) * integral);
}

}  // namespace litfog::measure
