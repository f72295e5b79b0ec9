// SPDX-License-Identifier: Apache-2.0
#include "render/airlight/airlight_bound.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "litfog/airlight.h"
#include "litfog/attenuation.h"
#include "litfog/formulas.h"
#include "render/light/hidden_range.h"
#include "render/light/light_threshold.h"

namespace litfog::render {

AirlightBound::AirlightBound(const PlacedLight& light, double extent, const Fog& fog, double largest_phase,
                             const glm::dvec3& eye)
    : attenuation_(light.light.attenuation),
      extent_(extent),
      fog_(scaled(fog, light.light.density_scale)),
      brightness_(kAirlightUnit * largest_phase * largest_component(light.light.color)),
      eye_range_(glm::distance(eye, light.position)) {
  fog_.density = std::min(fog_.density, 1e6);  // as in light_airlight.glsl
  weight_ = weight(2 * eye_range_ / 3, eye_range_ / 3);
}

double AirlightBound::reach(double budget) const {
  if (!(weight_ > 0)) return 0;
  const double most = brightness_ / budget;
  const double root = 4 * weight_ * most;
  const double denominator = std::min({most, 2 * extent_ * weight_ * most, root * root / attenuation_.quadratic});
  if (!(denominator > std::max(attenuation_.constant, 1.0))) return 0;
  return std::min({compute_extent(attenuation_, 1 / denominator), extent_, kFarthestReach});
}

double AirlightBound::end(double budget) const {
  const double integral =
      formulas::litfog_largest_attenuation_integral(attenuation_.constant, attenuation_.quadratic, 2 * extent_);
  const double x = hidden_range(fog_, brightness_ * weight(0, 0) * integral, budget);
  if (fog_.mode == FogMode::exp) return eye_range_ >= x ? 0 : (x + eye_range_) / 2;
  const double square = 6 * x * x - 2 * eye_range_ * eye_range_;
  return square <= 0 ? 0 : (2 * eye_range_ + std::sqrt(square)) / 3;
}

double AirlightBound::beyond_extent(double distance) const {
  const double range = std::max(extent_, distance - eye_range_);
  const double beyond =
      attenuation_at(attenuation_, range) * fog_factor_at(fog_, range) * fog_factor_at(fog_, distance);
  const double largest_weight = std::min(weight_, weight(distance, range));
  return brightness_ * std::min(beyond, largest_weight * std::numbers::pi / (attenuation_.quadratic * range));
}

double AirlightBound::width() const { return compute_extent(attenuation_, 0.5 / std::max(attenuation_.constant, 1.0)); }

double AirlightBound::flat_range() const { return 0.5 * std::min(width(), 0.5 / fog_.density); }

double AirlightBound::k() const {
  const double slope = std::max(attenuation_.quadratic, attenuation_.linear / std::max(width(), 1e-3));
  return brightness_ * weight_ * 4 / std::max(slope, 1e-30);
}

double AirlightBound::weight(double seen, double lit) const {
  return formulas::litfog_largest_fog_weight(double(fog_.mode), fog_.density, seen, lit);
}

}  // namespace litfog::render
