// SPDX-License-Identifier: Apache-2.0
#include "window/range_curve.h"

#include <cmath>

namespace litfog::window {
namespace {

/// The end of a plot: beyond the extent, else beyond the peak, else 4 optical depths.
double end_of(const FogIntensity& solved, const Fog& fog) {
  if (std::isfinite(solved.extent) && solved.extent > 0) return solved.extent * 1.1;
  if (std::isfinite(solved.peak_range) && solved.peak_range > 0) return solved.peak_range * 4;
  if (std::isfinite(fog.density) && fog.density > 0) return 4 / fog.density;
  return 100;
}

}  // namespace

RangeCurve make_range_curve(const Light& light, const Fog& fog, int samples) {
  const Fog seen = scaled(fog, light.density_scale);
  RangeCurve curve{
      .solved = solve_fog_intensity(light, fog), .knee = compute_knee(light.attenuation), .end = 0, .samples = {}};
  curve.end = end_of(curve.solved, seen);
  for (int i = 0; i < samples; ++i) {
    const double range = curve.end * i / (samples - 1);
    const double opacity = opacity_at(seen, range);
    const double attenuation = range <= curve.solved.extent ? attenuation_at(light.attenuation, range) : 0;
    curve.samples.push_back({opacity, attenuation, opacity * attenuation});
  }
  return curve;
}

}  // namespace litfog::window
