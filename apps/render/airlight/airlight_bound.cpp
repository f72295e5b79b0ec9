// SPDX-License-Identifier: Apache-2.0
#include "render/airlight/airlight_bound.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "litfog/airlight.h"
#include "litfog/attenuation.h"
#include "litfog/formulas.h"
#include "render/airlight/far_airlight_list.h"
#include "render/light/light_threshold.h"
#include "render/plan/fog_top.h"

namespace litfog::render {

namespace {

/// Metres from the light at which its bands of height end, besides at knots.
constexpr std::array<double, 4> kBandEnds{2, 8, 32, 128};
/// Where bands end between knots of different densities.
constexpr std::array<double, 4> kRampParts{0.1, 0.3, 0.7, 0.9};

constexpr double kFlatDepth = 0.02;  // optical, below which scattered_at() is even

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
      mode_(atmosphere.fog.mode),
      is_layered_(atmosphere.profile.count > 0),
      scattering_(&scattering),
      glow_(glow),
      brightness_(airlight_unit(atmosphere) * largest_component(light.light.color)),
      eye_range_(glm::distance(eye, light.position)) {
  const bool sees_layers_from_outside = is_layered_ && !(atmosphere.fog_at(eye.y).density > 0);
  const double rise = std::max(std::abs(eye.y - light.position.y), 1e-6);  // as in beside_peak()
  const double flattened = sees_layers_from_outside ? std::clamp(eye_range_ / rise, 1.0, kMostFlattened) : 1;
  near_ = eye_range_ * std::min(std::sin(FarAirlightList::kPeakAngle) * flattened, 1.0);
  const double scale = light.light.density_scale;
  const auto density_of = [&](const Fog& fog) { return std::min(scaled(fog, scale).density, LITFOG_DENSEST_FOG); };
  largest_density_ = density_of(atmosphere.thickest_fog());
  smallest_density_ = density_of(atmosphere.thinnest_fog());
  const auto add_band = [&](double lowest, double highest) {
    const double density = atmosphere.fog.density + litfog::largest_density(atmosphere.profile, lowest, highest);
    if (!(density > 0)) return;
    const auto leg = [&](double height) {
      return Leg{density_of(atmosphere.thinnest_fog_between(height, lowest, highest)),
                 std::max({lowest - height, height - highest, 0.0})};
    };
    bands_[band_count_++] = {density_of({mode_, density}), leg(eye.y), leg(light.position.y)};
  };
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  static_assert(kMaxBands == kMaxDensityKnots * (1 + kRampParts.size()) + 2 * kBandEnds.size() + 1);
  std::array<double, kMaxBands + 1> ends{-kInfinity, kInfinity};
  std::size_t end_count = 2;
  const std::span<const DensityKnot> knots = atmosphere.profile.used();
  for (std::size_t i = 0; i < knots.size(); ++i) {
    ends[end_count++] = knots[i].height;
    if (i + 1 == knots.size() || knots[i].density == knots[i + 1].density) continue;
    for (const double part : kRampParts) ends[end_count++] = std::lerp(knots[i].height, knots[i + 1].height, part);
  }
  if (atmosphere.profile.count > 0) {
    for (const double apart : kBandEnds) {
      ends[end_count++] = light.position.y - apart;
      ends[end_count++] = light.position.y + apart;
    }
  }
  const auto used = std::span(ends).first(end_count);
  std::ranges::sort(used);
  for (std::size_t i = 0; i + 1 < used.size(); ++i) {
    if (used[i] < used[i + 1]) add_band(used[i], used[i + 1]);
  }
}

double AirlightBound::angle_at(double distance) const {
  return distance < eye_range_ ? std::asin(distance / eye_range_) : std::numbers::pi / 2;
}

double AirlightBound::most_at(double distance) const {
  const auto [constant, linear, quadratic] = attenuation_;
  const double weight = largest_weight(0, distance);
  const double isotropic = formulas::litfog_largest_airlight(
      weight, formulas::denominator(distance, constant, linear, quadratic), quadratic, 2 * extent_);
  return brightness_ * std::min(largest_phase_at(distance) * isotropic,
                                weight * scattering_->integral_from(angle_at(distance)) / (quadratic * distance));
}

double AirlightBound::reach(double budget) const {
  double high = reach_where_phase_is(largest_phase_at(0), budget);
  if ((scattering_->is_isotropic() && band_count_ == 1) || !(high > 0)) return high;
  double low = 0;
  for (int i = 0; i < 40 && high > 1.01 * low; ++i) {
    const double middle = low > 0 ? std::sqrt(low * high) : high / 8;
    (most_at(middle) <= budget ? high : low) = middle;
  }
  return std::max(high, kLeastReach);
}

double AirlightBound::reach_where_phase_is(double phase, double budget) const {
  const double weight = largest_weight(0, 0);
  if (!(weight > 0)) return 0;
  const double most = phase * brightness_ / budget;
  const double root = 4 * weight * most;
  const double denominator = std::min({most, 2 * extent_ * weight * most, root * root / attenuation_.quadratic});
  if (!(denominator > std::max(attenuation_.constant, 1.0))) return 0;
  return std::min({compute_extent(attenuation_, 1 / denominator), extent_, kFarthestReach});
}

double AirlightBound::end(double budget) const {
  const double integral =
      formulas::litfog_largest_attenuation_integral(attenuation_.constant, attenuation_.quadratic, 2 * extent_);
  const auto end_where_phase_is = [&](double phase) {
    const double most = phase * brightness_ * integral;
    const auto is_beyond = [&](double distance) {
      return !(most * largest_weight(distance, std::max(distance - eye_range_, 0.0)) > budget);
    };
    if (is_beyond(0)) return 0.0;
    double low = 0, high = kSkyDistance;
    if (!is_beyond(high)) return std::numeric_limits<double>::infinity();
    while (high > 1.01 * low && high > 1e-3) {
      const double middle = low > 0 ? std::sqrt(low * high) : high / 8;
      (is_beyond(middle) ? high : low) = middle;
    }
    return high;
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
  return brightness_ * glow_.intensity * largest_density_ * largest_density_ * scattered_at(*glow_.table, depth, angle);
}

double AirlightBound::glow_in_layers(double range, double angle) const {
  double largest = 0;
  double density = largest_density_;
  do {  // of densities between the lamp and the place, from one to its half: the light falls with the depth
    const double thinner = density / 2;
    largest = std::max(largest, density * scattered_at(*glow_.table, thinner * range, angle));
    density = thinner;
  } while (density * range > kFlatDepth);
  return brightness_ * glow_.intensity * largest_density_ * largest;
}

double AirlightBound::glow_beside(double distance) const {
  if (!is_layered_) return glow_at(largest_density_ * eye_range_, angle_at(distance));
  double largest = 0;
  double before = std::max(eye_range_, kLeastReach);
  do {
    largest = std::max(largest, glow_in_layers(std::hypot(before / 2, distance), std::atan2(distance, before)));
    before /= 2;
  } while (before > std::max(distance / 4, kLeastReach));
  return largest;
}

double AirlightBound::higher_orders(double distance) const {
  if (!glow_.table) return 0;
  double weight = 0;
  for (const Band& band : bands()) {
    weight = std::max(weight,
                      band.density * fog_factor_at({mode_, band.seen.density}, std::max(distance, band.seen.nearest)));
  }
  weight /= largest_density_;
  const double beyond = distance - eye_range_;
  if (!is_layered_) return weight * glow_at(largest_density_ * std::abs(beyond), FarAirlightList::kPeakAngle);
  const double passing = 0.5 * near_;  // beside_peak() of shaders/airlight/higher_orders.glsl
  return weight * (beyond > 0 ? glow_in_layers(std::max(beyond, passing), std::numbers::pi / 2) : glow_beside(passing));
}

double AirlightBound::higher_orders_reach(double budget) const {
  if (!glow_.table) return 0;
  const auto softened = [&](double range) { return std::hypot(range, glow_.soft_range); };
  const double approach = std::sqrt(std::max(eye_range_ * eye_range_ - near_ * near_, 0.0));
  const double left_out =
      is_layered_ ? 0 : glow_at(largest_density_ * softened(eye_range_), std::atan2(softened(near_), approach));
  double low = 0, high = near_;
  if (glow_beside(0) - left_out <= budget) return 0;
  for (int i = 0; i < 12; ++i) {
    const double middle = (low + high) / 2;
    (glow_beside(middle) - left_out > budget ? low : high) = middle;
  }
  return high;
}

double AirlightBound::beyond_extent(double distance) const {
  const double range = std::max(extent_, distance - eye_range_);
  double sum = 0;
  for (const Band& band : bands()) sum += left(band, distance, range);
  const double through = std::min(sum, left({0, {smallest_density_, 0}, {smallest_density_, 0}}, distance, range));
  return brightness_ * std::min(attenuation_at(attenuation_, range) * through,
                                largest_weight(distance, range) * std::numbers::pi / (attenuation_.quadratic * range));
}

double AirlightBound::width() const { return compute_extent(attenuation_, 0.5 / std::max(attenuation_.constant, 1.0)); }

double AirlightBound::flat_range() const { return 0.5 * std::min(width(), 0.5 / largest_density_); }

double AirlightBound::k(double distance) const {
  // h^-3, as the airlight of a narrow lobe falls, has 15 times the fourth derivative of h^-1.
  const double bends =
      scattering_->is_isotropic() ? 1 : 15 * scattering_->integral_from(angle_at(distance)) / std::numbers::pi;
  const double slope = std::max(attenuation_.quadratic, attenuation_.linear / std::max(width(), 1e-3));
  return bends * brightness_ * largest_weight(0, 0) * 4 / std::max(slope, 1e-30);
}

AirlightBound::Distances AirlightBound::optical(const Band& band, double seen, double lit) const {
  seen = std::max(seen, band.seen.nearest);
  lit = std::max(lit, band.lit.nearest);
  const double rest = std::max(eye_range_ - seen - lit, 0.0);
  // The rest of the way is where it counts least: in exp fog on the thinner leg, in exp2 fog so that s is up to 2 r.
  const double on_seen = mode_ == FogMode::exp ? (band.seen.density < band.lit.density ? rest : 0)
                                               : std::clamp(2 * eye_range_ / 3 - seen, 0.0, rest);
  return {band.seen.density * (seen + on_seen), band.lit.density * (lit + rest - on_seen)};
}

double AirlightBound::left(const Band& band, double seen, double lit) const {
  return fog_factor_at({mode_, band.seen.density}, std::max(seen, band.seen.nearest)) *
         fog_factor_at({mode_, band.lit.density}, std::max(lit, band.lit.nearest));
}

double AirlightBound::largest_weight(double seen, double lit) const {
  double largest = 0;
  for (const Band& band : bands()) {
    const auto [x, y] = optical(band, seen, lit);
    largest = std::max(largest, formulas::litfog_largest_fog_weight(double(mode_), band.density, x, y));
  }
  return largest;
}

}  // namespace litfog::render
