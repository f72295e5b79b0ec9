// SPDX-License-Identifier: Apache-2.0
// What lights add by being scattered twice and more often, where has_higher_orders: render::HigherOrders. The sum over
// all lights is too coarse for the peak around a lamp, so that in it smaller angles count as litfog_far_peak_angle, and
// the rest is drawn light by light. Needs litfog/shaders/far_airlight.glsl before it.

#include "litfog/shaders/layered_scattering.glsl"
#include "litfog/shaders/multiple_scattering.glsl"

uniform samplerBuffer scattering_sources;  // HigherOrders::sources
const bool is_point = profile == LITFOG_PROFILE_NONE;

// M of a light over that of a point lamp, for what is scattered into the eye at a distance from it along the ray.
float scattered_share(vec4 source, LitfogAirlight air, float seen) {
  return is_point ? 1.0 : litfog_beam_share(air, seen - air.approach, source.y, source.z);
}

// The peak that reaches the eye from what lies behind a distance before the closest approach to the lamp.
float peak_beyond(vec4 source, LitfogAirlight air, float before) {
  return exp(-air.density * (air.approach - before)) *
         (litfog_scattered_from(air, -before, 0.0, source.w) -
          litfog_scattered_from(air, -before, litfog_far_peak_angle, source.w));
}

// In layers a lamp's glow has detail as fine as they are thick. For the sum over all lights, rays that pass the lamp
// within a distance count as passing it farther off, and as across its beam, so that the sum has no finer detail than
// its grid. The distance is that of litfog_far_peak_angle, up to most_flattened times as much where the eye looks down
// or up into layers from outside: neighbouring rays then meet the fog at places farther apart.
LitfogAirlight beside_peak(LitfogAirlight air) {
  float near = air.approach / litfog_far_peak_cotangent;
  if (air.density + air.layer_scale * litfog_profile_density(eye.y) == 0.0) {  // alike for all rays
    float rise = abs(eye.y - air.lamp_height);
    near *= clamp(length(vec2(air.approach, air.offset)) / max(rise, 1.0e-6), 1.0, most_flattened);
  }
  if (air.offset >= near) return air;
  float square = air.offset * air.offset / (near * near);
  air.offset = 0.5 * near * (1.0 + square);
  air.axis_offset *= square;
  air.axis_slope *= square;
  return air;
}

// Stretches between two knots, in which the peak is found to some 3 %.
const int peak_stretches = 4;

// Beam of litfog_scattered_in_stretch().
float beam_of(vec4 source) { return is_point ? -1.0 : source.y; }

float layered_peak(vec4 source, LitfogAirlight air) {
  LitfogAirlight beside = beside_peak(air);
  if (air.offset >= beside.offset) return 0.0;
  return source.x * max(litfog_layered_scattering(air, beside, peak_stretches, source.w, beam_of(source), source.z),
                        0.0);
}

// The derivative of the peak by the fog's opacity, at the end of the ray: of a short stretch there.
float higher_orders_gain(int light_index, LitfogAirlight air) {
  if (!litfog_airlight_is_layered(air)) return 0.0;
  LitfogAirlight beside = beside_peak(air);
  float from = 0.99 * air.ray_length;
  float eye_height = litfog_airlight_height(air, -air.approach);
  float before = litfog_fog_opacity(eye_height, eye_height + air.rise * from, from, 1.0);
  float added = litfog_fog_opacity(eye_height, eye_height + air.rise * air.ray_length, air.ray_length, 1.0) - before;
  if (air.offset >= beside.offset || added < 1.0e-4) return 0.0;
  vec4 source = texelFetch(scattering_sources, light_index);
  float peak = litfog_scattered_between(air, beside, litfog_slab(air), from, air.ray_length, 1, source.w,
                                        beam_of(source), source.z);
  return source.x * max(peak, 0.0) / added;
}

// The peak that the sum over all lights lacks: there is none but before the lamp. To be multiplied with the light's
// colour and litfog_airlight_unit().
float higher_orders_peak(int light_index, LitfogAirlight air) {
  if (litfog_airlight_is_layered(air)) return layered_peak(texelFetch(scattering_sources, light_index), air);
  float first = air.offset * litfog_far_peak_cotangent;  // where the angle is that of the peak
  float end = max(air.approach - air.ray_length, first);
  if (!(air.approach > end)) return 0.0;
  vec4 source = texelFetch(scattering_sources, light_index);
  float beyond = peak_beyond(source, air, air.approach);
  float at_end = end > first ? peak_beyond(source, air, end) : 0.0;
  if (is_point) return source.x * max(beyond - at_end, 0.0);
  const int pieces = 4;
  float step = pow(max(end / air.approach, 1.0e-3), 1.0 / float(pieces));
  float sum = 0.0;
  float before = air.approach;
  for (int i = 0; i < pieces; ++i) {
    float next = before * step;
    float beyond_next = i + 1 < pieces ? peak_beyond(source, air, next) : at_end;
    sum += max(beyond - beyond_next, 0.0) * scattered_share(source, air, air.approach - 0.5 * (before + next));
    before = next;
    beyond = beyond_next;
  }
  return source.x * sum;
}
