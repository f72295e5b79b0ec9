// SPDX-License-Identifier: Apache-2.0
#include "fit/cone_point.h"

#include <numbers>
#include <optional>
#include <utility>

#include "model/versine.h"

namespace litfog {

std::vector<ConePoint> points_of(const ConeTarget& target) {
  std::vector<ConePoint> points;
  if (target.beam_angle || target.field_angle) points.emplace_back(0, 1, 1);
  if (target.beam_angle) points.emplace_back(*target.beam_angle / 2, kBeamLevel, 1);
  if (target.field_angle) points.emplace_back(*target.field_angle / 2, kFieldLevel, 1);
  const double peak = peak_of(target.samples);
  for (const auto& [angle, intensity, weight] : target.samples) points.emplace_back(angle, intensity / peak, weight);
  std::stable_sort(points.begin(), points.end(),
                   [](const ConePoint& a, const ConePoint& b) { return a.angle < b.angle; });
  return points;
}

namespace {

/// The angle at which the points first fall to a fraction of their peak, if they do.
std::optional<double> half_angle_of(const std::vector<ConePoint>& points, double fraction) {
  std::vector<AxialSample> profile;
  for (const ConePoint& point : points) profile.push_back({point.angle, point.fraction, 0});
  const double angle = half_angle(profile, fraction);
  return angle < profile.back().angle ? std::optional(angle) : std::nullopt;
}

/// Flux of samples, linear between them, from the first to the last.
double flux_of(const std::vector<ConeSample>& samples) {
  double sum = 0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const double half = (samples[i].angle - samples[i - 1].angle) / 2;
    const double middle = samples[i - 1].angle + half;
    const double mean = samples[i - 1].intensity / 2 + samples[i].intensity / 2;
    const double skew = (samples[i].intensity - samples[i - 1].intensity) / 2;
    sum += mean * std::sin(middle) * std::sin(half) + skew * std::cos(middle) * mean_cosine_excess(half);
  }
  return 4 * std::numbers::pi * sum;
}

}  // namespace

ConeProfileFit assess(const Cone& cone, const std::vector<ConePoint>& points, const ConeTarget& target) {
  ConeProfileFit fit{.cone = cone};
  double weights = 0;
  for (const ConePoint& point : points) {
    const double error = cone_at(cone, point.cosine) - point.fraction;
    fit.objective += point.weight * error * error;
    weights += point.weight;
    if (std::abs(error) > std::abs(fit.largest_error)) {
      fit.largest_error = error;
      fit.largest_error_angle = point.angle;
    }
  }
  fit.rms = std::sqrt(fit.objective / weights);
  if (target.samples.size() > 1) {
    const double flux = flux_of(target.samples) / peak_of(target.samples);
    const auto [first, last] = std::pair(target.samples.front().angle, target.samples.back().angle);
    if (flux > 0) fit.flux_error = (flux_within(cone, last) - flux_within(cone, first)) / flux - 1;
  }
  const auto angle_error = [&](const std::optional<double>& stated, double level) -> std::optional<double> {
    const auto angle = stated ? *stated / 2 : half_angle_of(points, level);
    if (!angle) return std::nullopt;
    return angle_at_level(cone, level) / *angle - 1;
  };
  fit.beam_angle_error = angle_error(target.beam_angle, kBeamLevel);
  fit.field_angle_error = angle_error(target.field_angle, kFieldLevel);
  return fit;
}

}  // namespace litfog
