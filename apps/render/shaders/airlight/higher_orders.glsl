// SPDX-License-Identifier: Apache-2.0
// What lights add by being scattered twice and more often, where has_higher_orders: render::HigherOrders. The sum over
// all lights is too coarse for the peak around a lamp, so that in it smaller angles count as far_peak_angle, and the
// rest is drawn light by light. Needs far_peak.glsl before it.

#include "litfog/shaders/multiple_scattering.glsl"

uniform samplerBuffer scattering_sources;

// The light's effective intensity, reduced to what its cone sends along a ray.
float scattered_intensity(int light, LitfogAirlight air) {
  vec4 source = texelFetch(scattering_sources, light);
  return source.x * litfog_scattered_share(air, source.y, source.z, source.w);
}

// The peak that the sum over all lights lacks. To be multiplied with the light's colour and litfog_airlight_unit().
float higher_orders_peak(int light_index, LitfogAirlight air) {
  float peak = litfog_scattered_from(air, -air.approach, 0.0) - litfog_scattered_from(air, -air.approach, far_peak_angle);
  if (peak <= 0.0) return 0.0;
  if (air.ray_length < litfog_far) {
    peak -= litfog_scattered_beyond(air, air.ray_length, 0.0) - litfog_scattered_beyond(air, air.ray_length, far_peak_angle);
  }
  return scattered_intensity(light_index, air) * peak;
}
