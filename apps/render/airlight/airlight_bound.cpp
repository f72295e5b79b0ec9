// SPDX-License-Identifier: Apache-2.0
#include "render/airlight/airlight_bound.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "litfog/airlight.h"
#include "litfog/attenuation.h"
#include "litfog/formulas.h"
#include "render/airlight/far_airlight_list.h"
#include "render/light/hidden_range.h"
#include "render/light/light_threshold.h"

namespace litfog::render {

namespace {

constexpr double kSmallestAngle = 1e-4;  // radians: of the series, below which the peak of every lobe is flat

/// Angle i of the series.
double angle_of(double i, int angles) {
  return kSmallestAngle * std::pow(std::numbers::pi / kSmallestAngle, i / angles);
}

}  // namespace

ScatteringBound::ScatteringBound(const Phase& phase) : phase_(phase), is_isotropic_(litfog::is_isotropic(phase)) {
  for (int i = kAngles; i-- > 0 && !is_isotropic_;) {
    const double angle = angle_of(i, kAngles);
    integrals_[std::size_t(i)] =
        integrals_[std::size_t(i) + 1] + largest_from(angle) * (angle_of(i + 1, kAngles) - angle);
  }
}

double ScatteringBound::largest_from(double angle) const { return largest_phase(phase_, -1, std::cos(angle)); }

double ScatteringBound::integral_from(double angle) const {
  if (is_isotropic_) return std::numbers::pi - angle;
  const double place = kAngles * std::log(angle / kSmallestAngle) / std::log(std::numbers::pi / kSmallestAngle);
  if (!(place > 0)) return integrals_[0] + largest_from(0) * kSmallestAngle;
  const double i = std::floor(place);
  return integrals_[std::size_t(i) + 1] + largest_from(angle) * (angle_of(i + 1, kAngles) - angle);
}

AirlightBound::AirlightBound(const PlacedLight& light, double extent, const Atmosphere& atmosphere,
                             const ScatteringBound& scattering, const glm::dvec3& eye, const PointGlow& glow)
    : attenuation_(light.light.attenuation),
      extent_(extent),
      fog_(scaled(atmosphere.thinnest_fog(), light.light.density_scale)),
      largest_density_(scaled(atmosphere.thickest_fog(), light.light.density_scale).density),
      scattering_(&scattering),
      glow_(glow),
      brightness_(airlight_unit(atmosphere) * largest_component(light.light.color)),
      eye_range_(glm::distance(eye, light.position)) {
  constexpr double kDensest = 1e6;  // as in light_airlight.glsl
  fog_.density = std::min(fog_.density, kDensest);
  largest_density_ = std::min(largest_density_, kDensest);
  weight_ = weight(2 * eye_range_ / 3, eye_range_ / 3);
}

double AirlightBound::angle_at(double distance) const {
  return distance < eye_range_ ? std::asin(distance / eye_range_) : std::numbers::pi / 2;
}

double AirlightBound::most_at(double distance) const {
  const auto [constant, linear, quadratic] = attenuation_;
  const double isotropic = formulas::litfog_largest_airlight(
      weight_, formulas::denominator(distance, constant, linear, quadratic), quadratic, 2 * extent_);
  return brightness_ * std::min(largest_phase_at(distance) * isotropic,
                                weight_ * scattering_->integral_from(angle_at(distance)) / (quadratic * distance));
}

double AirlightBound::reach(double budget) const {
  double high = reach_where_phase_is(largest_phase_at(0), budget);
  if (scattering_->is_isotropic() || !(high > 0)) return high;
  double low = 0;
  for (int i = 0; i < 40 && high > 1.01 * low; ++i) {
    const double middle = low > 0 ? std::sqrt(low * high) : high / 8;
    (most_at(middle) <= budget ? high : low) = middle;
  }
  return high;
}

double AirlightBound::reach_where_phase_is(double phase, double budget) const {
  if (!(weight_ > 0)) return 0;
  const double most = phase * brightness_ / budget;
  const double root = 4 * weight_ * most;
  const double denominator = std::min({most, 2 * extent_ * weight_ * most, root * root / attenuation_.quadratic});
  if (!(denominator > std::max(attenuation_.constant, 1.0))) return 0;
  return std::min({compute_extent(attenuation_, 1 / denominator), extent_, kFarthestReach});
}

double AirlightBound::end(double budget) const {
  const double integral =
      formulas::litfog_largest_attenuation_integral(attenuation_.constant, attenuation_.quadratic, 2 * extent_);
  const auto end_where_phase_is = [&](double phase) {
    const double x = hidden_range(fog_, phase * brightness_ * weight(0, 0) * integral, budget);
    if (fog_.mode == FogMode::exp) return eye_range_ >= x ? 0 : (x + eye_range_) / 2;
    const double square = 6 * x * x - 2 * eye_range_ * eye_range_;
    return square <= 0 ? 0 : (2 * eye_range_ + std::sqrt(square)) / 3;
  };
  const double beyond_light = end_where_phase_is(largest_phase_at(eye_range_));
  if (beyond_light >= eye_range_) return beyond_light;
  if (far_peak_reach(budget) > 0) return eye_range_;
  return std::min(end_where_phase_is(largest_phase_at(0)), eye_range_);
}

double AirlightBound::far_peak_reach(double budget) const {
  if (scattering_->is_isotropic() || extent_ >= eye_range_) return 0;
  const double beyond = beyond_extent(0);
  const double farthest = eye_range_ * std::sin(FarAirlightList::kPeakAngle);
  double low = 0, high = farthest;
  if (largest_phase_at(low) * beyond <= budget) return 0;
  if (largest_phase_at(high) * beyond > budget) return farthest;
  for (int i = 0; i < 24; ++i) {
    const double middle = (low + high) / 2;
    (largest_phase_at(middle) * beyond > budget ? low : high) = middle;
  }
  return high;
}

double AirlightBound::glow_at(double depth, double angle) const {
  return brightness_ * glow_.intensity * fog_.density * fog_.density * scattered_at(*glow_.table, depth, angle);
}

double AirlightBound::higher_orders(double distance) const {
  if (!glow_.table) return 0;
  const double depth = fog_.density * std::abs(distance - eye_range_);
  return fog_factor_at(fog_, distance) * glow_at(depth, FarAirlightList::kPeakAngle);
}

double AirlightBound::higher_orders_reach(double budget) const {
  if (!glow_.table) return 0;
  const double depth = fog_.density * eye_range_;
  const double left_out = glow_at(depth, FarAirlightList::kPeakAngle);
  const auto peak_at = [&](double angle) { return glow_at(depth, angle) - left_out; };
  double low = 0, high = FarAirlightList::kPeakAngle;
  if (peak_at(low) <= budget) return 0;
  for (int i = 0; i < 24; ++i) {
    const double middle = (low + high) / 2;
    (peak_at(middle) > budget ? low : high) = middle;
  }
  return eye_range_ * std::sin(high);
}

double AirlightBound::beyond_extent(double distance) const {
  const double range = std::max(extent_, distance - eye_range_);
  const double beyond =
      attenuation_at(attenuation_, range) * fog_factor_at(fog_, range) * fog_factor_at(fog_, distance);
  const double largest_weight = std::min(weight_, weight(distance, range));
  return brightness_ * std::min(beyond, largest_weight * std::numbers::pi / (attenuation_.quadratic * range));
}

double AirlightBound::width() const { return compute_extent(attenuation_, 0.5 / std::max(attenuation_.constant, 1.0)); }

double AirlightBound::flat_range() const { return 0.5 * std::min(width(), 0.5 / largest_density_); }

double AirlightBound::k(double distance) const {
  // h^-3, as the airlight of a narrow lobe falls, has 15 times the fourth derivative of h^-1.
  const double bends =
      scattering_->is_isotropic() ? 1 : 15 * scattering_->integral_from(angle_at(distance)) / std::numbers::pi;
  const double slope = std::max(attenuation_.quadratic, attenuation_.linear / std::max(width(), 1e-3));
  const double single = bends * brightness_ * weight_ * 4 / std::max(slope, 1e-30);
  return glow_.table ? single + distance * glow_at(fog_.density * eye_range_, angle_at(distance)) : single;
}

double AirlightBound::weight(double seen, double lit) const {
  return formulas::litfog_largest_fog_weight(double(fog_.mode), fog_.density, largest_density_, seen, lit);
}

}  // namespace litfog::render
