// SPDX-License-Identifier: Apache-2.0
// What the peak of the phase function adds to the airlight of a light beyond its extent: the sum of far_airlight.frag is
// too coarse for it. Along rays that pass a far light within far_peak_angle, the fog between the eye and the extent
// scatters more by the difference of the phase function to its value at that angle.

const float far_peak_angle = 0.15;  // FarAirlightList::kPeakAngle
const float far_peak_versine = 2.0 * sin(0.5 * far_peak_angle) * sin(0.5 * far_peak_angle);
const float far_peak_cotangent = 1.0 / tan(far_peak_angle);

// To be multiplied with the light's colour and litfog_airlight_unit().
float far_peak(LitfogAirlight air) {
  if (litfog_is_isotropic(air.phase)) return 0.0;
  // The stretch as distances before the closest approach to the light.
  float nearest = max(max(litfog_airlight_chord(air, air.extent), air.offset * far_peak_cotangent),
                      air.approach - air.ray_length);
  if (!(air.approach > nearest) || air.offset * far_peak_cotangent >= air.approach || nearest <= 0.0) return 0.0;
  float at_peak_angle = litfog_phase(air.phase, far_peak_versine);
  LitfogPhase phase = air.phase;
  air.phase = litfog_isotropic;
  float size = log(air.approach / nearest);
  float sum = 0.0;
  const int nodes = 6;
  const int first = nodes * (nodes - 1) / 2;
  for (int i = first; i < first + nodes; ++i) {
    float before = nearest * exp(size * litfog_gauss_nodes[i]);
    float at_range = litfog_airlight_range(air, -before);
    float above = litfog_phase(phase, litfog_airlight_versine(air, -before, at_range)) - at_peak_angle;
    sum += litfog_gauss_weights[i] * before * above * litfog_airlight_integrand(air, -before);
  }
  return size * sum;
}
