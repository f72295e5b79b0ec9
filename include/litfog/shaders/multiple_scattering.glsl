// SPDX-License-Identifier: Apache-2.0
// litfog: light of a point lamp that exp fog scatters to the eye twice and more often, M of litfog/multiple_scattering.h.
// airlight.glsl has what is scattered once. Shared with C++ as airlight.glsl is; GLSL includes it after
// light_airlight.glsl.
//
// In Vulkan the table is at LITFOG_SET (default 0) and LITFOG_SCATTERING_BINDING (default 3).

#ifndef LITFOG_MULTIPLE_SCATTERING_GLSL
#define LITFOG_MULTIPLE_SCATTERING_GLSL

#ifndef __cplusplus
#include "litfog/shaders/light_airlight.glsl"

// The table of make_scattering_table(): a texture of one component with linear filters, clamped to its edges, an angle a
// column and a depth a row.
#ifdef VULKAN
#ifndef LITFOG_SET
#define LITFOG_SET 0
#endif
#ifndef LITFOG_SCATTERING_BINDING
#define LITFOG_SCATTERING_BINDING 3
#endif
layout(set = LITFOG_SET, binding = LITFOG_SCATTERING_BINDING)
#endif
uniform highp sampler2D litfog_scattering_table;

float litfog_scattering_log(float depth, float angle) {
  return textureLod(litfog_scattering_table, (vec2(angle, depth) + 0.5) / vec2(69.0, 45.0), 0.0).r;
}

#define LITFOG_REAL float
#define LITFOG_CONSTANT const
#endif

// The table's depths x go by equal steps of ln x + 0.3 x, its angles x in radians by equal steps of ln x + x / 2. These
// are the first of each, its logarithm's place and the step.
LITFOG_CONSTANT LITFOG_REAL litfog_least_scattering_depth = LITFOG_REAL(0.02);
LITFOG_CONSTANT LITFOG_REAL litfog_most_scattering_depth = LITFOG_REAL(10.0);
LITFOG_CONSTANT LITFOG_REAL litfog_first_scattering_depth = LITFOG_REAL(-3.906023005428146);
LITFOG_CONSTANT LITFOG_REAL litfog_scattering_depth_step = LITFOG_REAL(0.2092865476914135);
LITFOG_CONSTANT LITFOG_REAL litfog_least_scattering_angle = LITFOG_REAL(0.00349065850399);  // 0.2 degrees
LITFOG_CONSTANT LITFOG_REAL litfog_first_scattering_angle = LITFOG_REAL(-5.655919548222917);
LITFOG_CONSTANT LITFOG_REAL litfog_scattering_angle_step = LITFOG_REAL(0.1231094964833414);

// M d^-2 of a lamp of 1 / r^2 in endless fog of density d, at an optical depth from the lamp and an angle between the ray
// and the direction to the lamp. Depths and angles below the table's count as its first. Beyond its last depth the light
// falls as that of diffusion does, by 1 / depth.
LITFOG_REAL litfog_scattered_at(LITFOG_REAL depth, LITFOG_REAL angle) {
  LITFOG_REAL x = clamp(depth, litfog_least_scattering_depth, litfog_most_scattering_depth);
  LITFOG_REAL y = max(angle, litfog_least_scattering_angle);
  LITFOG_REAL row = (log(x) + LITFOG_REAL(0.3) * x - litfog_first_scattering_depth) / litfog_scattering_depth_step;
  LITFOG_REAL column = (log(y) + LITFOG_REAL(0.5) * y - litfog_first_scattering_angle) / litfog_scattering_angle_step;
  return exp(litfog_scattering_log(row, column)) * (x / max(depth, x));
}

// M, over the lamp's effective intensity, that a point on the ray receives from there on in endless fog. The point is at a
// distance along the ray from the closest approach. Angles below the least one, radians, count as that. In the lamp itself
// the angle is a right one, as atan(0, 0) is not defined.
LITFOG_REAL litfog_scattered_from(LitfogAirlight air, LITFOG_REAL along, LITFOG_REAL least_angle) {
  LITFOG_REAL depth = air.density * litfog_airlight_range(air, along);
  return air.density * air.density * litfog_scattered_at(depth, max(atan(max(air.offset, LITFOG_REAL(1.0e-30)), -along), least_angle));
}

// The same as the eye sees it through the fog before the point, a distance from the eye.
LITFOG_REAL litfog_scattered_beyond(LitfogAirlight air, LITFOG_REAL range, LITFOG_REAL least_angle) {
  return exp(-air.density * range) * litfog_scattered_from(air, range - air.approach, least_angle);
}

// M of a cone over that of a point lamp of its intensity, about. Which directions from the lamp matter is spread along the
// ray as what is scattered once there is, over the angle at the lamp, and blurred by the scatterings before. A cone of so
// many directions is about a lobe of Henyey and Greenstein with its flux and its mean cosine.
//
// flux          the cone's mean over all directions
// cone_cosine   its mean cosine
// phase_cosine  that of the phase function
LITFOG_REAL litfog_scattered_share(LitfogAirlight air, LITFOG_REAL flux, LITFOG_REAL cone_cosine,
                                   LITFOG_REAL phase_cosine) {
  if (flux >= LITFOG_REAL(1.0)) return LITFOG_REAL(1.0);
  LITFOG_REAL range = max(litfog_airlight_range(air, -air.approach), LITFOG_REAL(1.0e-6));
  LITFOG_REAL depth = air.density * range;
  LITFOG_REAL turned = LITFOG_REAL(1.0) - phase_cosine;
  // Fitted to random walks in isotropic fog and in droplets of 10 micrometres.
  LITFOG_REAL octaves = log(max(depth, LITFOG_REAL(0.3))) / LITFOG_REAL(1.0986);
  LITFOG_REAL even = (LITFOG_REAL(0.4) + LITFOG_REAL(0.2) * clamp(octaves, LITFOG_REAL(0.0), LITFOG_REAL(2.0))) *
                     turned * turned;
  LITFOG_REAL kept = LITFOG_REAL(0.4) + LITFOG_REAL(0.55) * phase_cosine;
  LITFOG_REAL dimming = clamp(octaves + LITFOG_REAL(1.0), LITFOG_REAL(0.0), LITFOG_REAL(2.0)) * turned;
  LITFOG_REAL lobe = min(kept * cone_cosine, LITFOG_REAL(0.99));

  LITFOG_REAL at_eye = (air.axis_offset - air.approach * air.axis_slope) / range;  // cosines to the axis
  // Towards the lamp, directions across the line of sight are blurred altogether, so that the share is smooth there.
  LITFOG_REAL sine = air.offset / range;
  LITFOG_REAL across = (air.axis_slope + air.approach / range * at_eye) / (sine + LITFOG_REAL(0.15));
  LITFOG_REAL at_lamp = LITFOG_REAL(3.14159265) - atan(air.offset, air.approach);  // angle of the whole ray
  LITFOG_REAL sum = LITFOG_REAL(0.0);
  LITFOG_REAL weights = LITFOG_REAL(0.0);
  const int nodes = 4;
  const int first = nodes * (nodes - 1) / 2;
  for (int i = first; i < first + nodes; ++i) {
    LITFOG_REAL angle = at_lamp * litfog_gauss_nodes[i];
    LITFOG_REAL cosine = clamp(cos(angle) * at_eye + sin(angle) * across, LITFOG_REAL(-1.0), LITFOG_REAL(1.0));
    LITFOG_REAL scattered = LITFOG_REAL(3.14159265) - at_lamp + angle;
    LITFOG_REAL legs = (sin(angle) + sine) / max(sin(scattered), LITFOG_REAL(1.0e-6));  // over the range
    LITFOG_REAL weight = litfog_gauss_weights[i] * litfog_phase(air.phase, LITFOG_REAL(1.0) - cos(scattered)) *
                         exp(-dimming * depth * (legs - LITFOG_REAL(1.0)));
    LITFOG_REAL base = LITFOG_REAL(1.0) + lobe * lobe - LITFOG_REAL(2.0) * lobe * cosine;
    sum += weight * (even + (LITFOG_REAL(1.0) - even) * (LITFOG_REAL(1.0) - lobe * lobe) / (base * sqrt(base)));
    weights += weight;
  }
  return min(flux * sum / max(weights, LITFOG_REAL(1.0e-30)), LITFOG_REAL(1.0));
}

// M of a point lamp along a ray of exp fog, over the lamp's effective intensity: what the eye would receive from endless
// fog without what comes from beyond the ray's end.
LITFOG_REAL litfog_multiple_scattering(LitfogAirlight air) {
  LITFOG_REAL all = litfog_scattered_from(air, -air.approach, LITFOG_REAL(0.0));
  if (!(air.ray_length < litfog_far)) return all;
  return max(all - litfog_scattered_beyond(air, air.ray_length, LITFOG_REAL(0.0)), LITFOG_REAL(0.0));
}

#undef LITFOG_REAL
#undef LITFOG_CONSTANT

#endif
