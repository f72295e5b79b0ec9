// SPDX-License-Identifier: Apache-2.0
#include "fit/two_lights.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "litfog/photometry/axial_beam.h"

namespace litfog::fit {
namespace {

/// A beam cut in two at a level of its peak.
struct Split {
  ConeTarget hot_spot, spill;  ///< to fit
  double error = std::numeric_limits<double>::infinity();
};

/// Samples without what lies inside a level around their peak, of which the axis keeps the level.
std::vector<ConeSample> outside_of(std::vector<ConeSample> samples, double level) {
  const auto brightest = std::ranges::max_element(samples, {}, &ConeSample::intensity);
  const auto outside =
      std::find_if(brightest, samples.end(), [level](const ConeSample& sample) { return sample.intensity <= level; });
  for (auto sample = samples.begin(); sample != outside; ++sample) sample->weight = 0;
  for (ConeSample& sample : samples) sample.intensity = std::min(sample.intensity, level);
  samples.front() = {samples.front().angle, level, 1};
  return samples;
}

Split split_at(const ConeTarget& whole, double level) {
  Split split{.hot_spot = whole, .spill = whole};
  split.spill.samples = outside_of(whole.samples, level);
  if (find_error(split.spill)) return split;  // the beam ends above the level
  const Cone spill = fit_cone(split.spill).best().cone;
  for (ConeSample& sample : split.hot_spot.samples) {
    sample.intensity = std::max(sample.intensity - level * cone_at(spill, std::cos(sample.angle)), 0.0);
  }
  const Cone hot_spot = fit_cone(split.hot_spot).best().cone;
  const double peak = peak_of(split.hot_spot.samples);
  split.error = 0;
  for (std::size_t i = 1; i < whole.samples.size(); ++i) {
    const ConeSample &before = whole.samples[i - 1], &after = whole.samples[i];
    const double area = std::cos(before.angle) - std::cos(after.angle);
    const double cosine = std::cos(std::midpoint(before.angle, after.angle));
    const double error = peak * cone_at(hot_spot, cosine) + level * cone_at(spill, cosine) -
                         std::midpoint(before.intensity, after.intensity);
    split.error += area * error * error;
  }
  return split;
}

/// The level is searched twice: in steps of half an octave, then of a sixteenth.
Split best_split(const ConeTarget& whole) {
  const double peak = peak_of(whole.samples);
  constexpr double kLargest = 0.6;
  double first = 0, step = 0.5;  // octaves below the largest level
  Split best;
  for (int turn = 0; turn < 2; ++turn) {
    double best_octave = first;
    for (int i = 0; i < 16; ++i) {
      const double octave = first + i * step;
      Split split = split_at(whole, kLargest * std::exp2(-octave) * peak);
      if (split.error >= best.error) continue;
      best = std::move(split);
      best_octave = octave;
    }
    first = std::max(best_octave - step, 0.0);
    step /= 8;
  }
  return best;
}

}  // namespace

std::optional<TwoLights> fit_two_lights(const LightFit& fit) {
  const LightTarget& target = fit.target;
  if (!target.luminaire || !target.end_illuminance || !target.range->samples.empty()) return std::nullopt;
  const Split split = best_split(*target.cone);
  if (std::isinf(split.error)) return std::nullopt;
  TwoLights both{.hot_spot = fit_light(part_of(target, "hot spot", split.hot_spot)),
                 .spill = fit_light(part_of(target, "spill", split.spill)),
                 .beam_error = 0,
                 .flux_error = 0,
                 .peak_error = 0,
                 .illuminance_error = {},
                 .beam = {}};
  const auto candela_at = [&both](double angle) {
    const double cosine = std::cos(angle);
    return *both.hot_spot.peak * cone_at(both.hot_spot.light.cone, cosine) +
           *both.spill.peak * cone_at(both.spill.light.cone, cosine);
  };
  std::vector<AxialSample> profile;
  for (const ConeSample& sample : target.cone->samples) profile.push_back({sample.angle, candela_at(sample.angle), 0});
  both.beam_error = fit.beam_error_of(candela_at);
  both.beam = {.peak = *both.hot_spot.peak + *both.spill.peak,
               .flux = *both.hot_spot.flux + *both.spill.flux,
               .beam_angle = {2 * half_angle(profile, 0.5)},
               .field_angle = {2 * half_angle(profile, 0.1)}};
  both.flux_error = *both.beam.flux / luminous_flux(target.luminaire->distribution) - 1;
  both.peak_error = candela_at(fit.peak_angle) / target.luminaire_peak.intensity - 1;
  both.illuminance_error = largest_error(target.illuminance, [&](double range) {
    return illuminance_at(both.hot_spot.light, range, fit.peak_angle) +
           illuminance_at(both.spill.light, range, fit.peak_angle);
  });
  return both;
}

}  // namespace litfog::fit
