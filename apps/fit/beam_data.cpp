// SPDX-License-Identifier: Apache-2.0
#include "fit/beam_data.h"

#include <numbers>

namespace litfog::fit {
namespace {

using std::numbers::pi;

std::vector<double> full_angles(const LightFit& fit, double fraction) {
  const IntensityDistribution& distribution = fit.target.luminaire->distribution;
  const glm::dvec3& axis = fit.target.axis;
  if (fit.target.asymmetry <= kRoundBeam) return {2 * half_angle(axial_profile(distribution, axis), fraction)};
  const auto in_plane = [&](double turn) {
    return half_angle(plane_profile(distribution, turn, axis), fraction) +
           half_angle(plane_profile(distribution, turn + pi, axis), fraction);
  };
  return {in_plane(0), in_plane(pi / 2)};
}

std::vector<double> full_angle(const std::optional<double>& stated, const std::vector<ConeSample>& samples,
                               double fraction) {
  if (stated) return {*stated};
  std::vector<AxialSample> profile;
  for (const ConeSample& sample : samples) {
    if (sample.weight > 0) profile.push_back({sample.angle, sample.intensity, 0});
  }
  if (profile.empty()) return {};
  const double angle = half_angle(profile, fraction);
  return angle < profile.back().angle ? std::vector{2 * angle} : std::vector<double>{};
}

}  // namespace

BeamData beam_data(const LightFit& fit) {
  if (fit.target.luminaire) {
    const IntensityDistribution& distribution = fit.target.luminaire->distribution;
    return {.peak = find_peak(distribution).intensity,
            .flux = luminous_flux(distribution),
            .beam_angle = full_angles(fit, 0.5),
            .field_angle = full_angles(fit, 0.1)};
  }
  if (!fit.target.cone) return {};
  const ConeTarget& target = *fit.target.cone;
  return {.peak = std::nullopt,
          .flux = std::nullopt,
          .beam_angle = full_angle(target.beam_angle, target.samples, 0.5),
          .field_angle = full_angle(target.field_angle, target.samples, 0.1)};
}

}  // namespace litfog::fit
