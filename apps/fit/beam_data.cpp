// SPDX-License-Identifier: Apache-2.0
#include "fit/light_fit.h"

#include <array>
#include <numbers>

namespace litfog::fit {
namespace {

using std::numbers::pi;

/// The beam on both sides of the axis.
using Plane = std::array<std::vector<AxialSample>, 2>;

/// The profile of the samples with weight.
std::vector<AxialSample> profile_of(const std::vector<ConeSample>& samples) {
  std::vector<AxialSample> profile;
  for (const ConeSample& sample : samples) {
    if (sample.weight > 0) profile.push_back({sample.angle, sample.intensity, 0});
  }
  return profile;
}

/// One plane of a round beam, the mean over the turn; else the horizontal and the vertical one.
std::vector<Plane> planes_of(const LightTarget& target) {
  const IntensityDistribution& distribution = target.luminaire->distribution;
  if (target.asymmetry <= kRoundBeam) {
    const std::vector<AxialSample> profile = profile_of(target.cone->samples);  // the luminaire's about that axis
    return {{profile, profile}};
  }
  const auto plane = [&](double turn) {
    return Plane{plane_profile(distribution, turn, target.axis), plane_profile(distribution, turn + pi, target.axis)};
  };
  return {plane(0), plane(pi / 2)};
}

std::vector<double> full_angles(const std::vector<Plane>& planes, double fraction) {
  std::vector<double> angles;
  for (const auto& [right, left] : planes) angles.push_back(half_angle(right, fraction) + half_angle(left, fraction));
  return angles;
}

/// None is known of samples that end above the fraction.
std::vector<double> full_angle(const std::optional<double>& stated, const std::vector<ConeSample>& samples,
                               double fraction) {
  if (stated) return {*stated};
  const std::vector<AxialSample> profile = profile_of(samples);
  if (profile.empty()) return {};
  const double angle = half_angle(profile, fraction);
  return angle < profile.back().angle ? std::vector{2 * angle} : std::vector<double>{};
}

}  // namespace

BeamData beam_data(const LightFit& fit) {
  if (fit.target.luminaire) {
    const std::vector<Plane> planes = planes_of(fit.target);
    return {.peak = fit.target.luminaire_peak.intensity,
            .flux = luminous_flux(fit.target.luminaire->distribution),
            .beam_angle = full_angles(planes, 0.5),
            .field_angle = full_angles(planes, 0.1)};
  }
  BeamData data{.peak = fit.target.peak, .flux = fit.target.flux, .beam_angle = {}, .field_angle = {}};
  if (!fit.target.cone) return data;
  const ConeTarget& target = *fit.target.cone;
  data.beam_angle = full_angle(target.beam_angle, target.samples, 0.5);
  data.field_angle = full_angle(target.field_angle, target.samples, 0.1);
  for (const auto& [level, angles] : fit.target.ellipses) {
    if (!angles.is_round()) (level == 0.5 ? data.beam_angle : data.field_angle) = {angles.horizontal, angles.vertical};
  }
  return data;
}

BeamData light_beam(const LightFit& fit) {
  BeamData beam{.peak = fit.peak, .flux = fit.flux, .beam_angle = {}, .field_angle = {}};
  if (fit.cookie) {
    const BeamData data = beam_data(fit);
    beam.beam_angle = data.beam_angle;
    beam.field_angle = data.field_angle;
  } else if (fit.cone) {
    beam.beam_angle = {2 * angle_at_level(fit.light.cone, 0.5)};
    beam.field_angle = {2 * angle_at_level(fit.light.cone, 0.1)};
  }
  return beam;
}

}  // namespace litfog::fit
