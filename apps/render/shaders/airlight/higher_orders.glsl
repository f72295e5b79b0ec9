// SPDX-License-Identifier: Apache-2.0
// What lights add by being scattered twice and more often, where has_higher_orders: render::HigherOrders. The sum over
// all lights is too coarse for the peak around a lamp, so that in it smaller angles count as far_peak_angle, and the
// rest is drawn light by light. Needs far_peak.glsl before it.

#include "litfog/shaders/multiple_scattering.glsl"

uniform samplerBuffer scattering_sources;  // HigherOrders::sources
const float point_beam = 0.0;              // HigherOrders::kPointBeam

// M of a light over that of a point lamp, for what is scattered into the eye at a distance from it along the ray.
float scattered_share(vec4 source, LitfogAirlight air, float seen) {
  return source.y == point_beam ? 1.0 : litfog_beam_share(air, seen - air.approach, source.y, source.z);
}

// The peak that reaches the eye from what lies behind a distance before the closest approach to the lamp.
float peak_beyond(LitfogAirlight air, float before) {
  return exp(-air.density * (air.approach - before)) *
         (litfog_scattered_from(air, -before, 0.0) - litfog_scattered_from(air, -before, far_peak_angle));
}

// The peak that the sum over all lights lacks: there is none but before the lamp. To be multiplied with the light's colour
// and litfog_airlight_unit().
float higher_orders_peak(int light_index, LitfogAirlight air) {
  float first = air.offset * far_peak_cotangent;  // where the angle is that of the peak
  float end = max(air.approach - air.ray_length, first);
  if (!(air.approach > end)) return 0.0;
  vec4 source = texelFetch(scattering_sources, light_index);
  float beyond = peak_beyond(air, air.approach);
  float at_end = end > first ? peak_beyond(air, end) : 0.0;
  if (source.y == point_beam) return source.x * max(beyond - at_end, 0.0);
  const int pieces = 4;
  float step = pow(max(end / air.approach, 1.0e-3), 1.0 / float(pieces));
  float sum = 0.0;
  float before = air.approach;
  for (int i = 0; i < pieces; ++i) {
    float next = before * step;
    float beyond_next = i + 1 < pieces ? peak_beyond(air, next) : at_end;
    sum += max(beyond - beyond_next, 0.0) * scattered_share(source, air, air.approach - 0.5 * (before + next));
    before = next;
    beyond = beyond_next;
  }
  return source.x * sum;
}
