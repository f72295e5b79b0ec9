// SPDX-License-Identifier: Apache-2.0
// litfog: light of a point lamp that exp fog scatters to the eye twice and more often, M of litfog/multiple_scattering.h.
// airlight.glsl has what is scattered once. Shared with C++ as airlight.glsl is; GLSL includes it after
// light_airlight.glsl.

#ifndef LITFOG_MULTIPLE_SCATTERING_GLSL
#define LITFOG_MULTIPLE_SCATTERING_GLSL

#ifndef __cplusplus
#include "litfog/shaders/light_airlight.glsl"

// The table of pack_scattering_table(): a texture of one component with linear filters, clamped to its edges, an angle a
// column and a depth a row.
uniform sampler2D litfog_scattering_table;

float litfog_scattering_log(float depth, float angle) {
  return textureLod(litfog_scattering_table, (vec2(angle, depth) + 0.5) / vec2(18.0, 12.0), 0.0).r;
}

#define LITFOG_REAL float
#define LITFOG_CONSTANT const
#endif

// The table's depths and angles in radians go by equal ratios; these are the first and the logarithm of the ratio.
LITFOG_CONSTANT LITFOG_REAL litfog_least_scattering_depth = LITFOG_REAL(0.02);
LITFOG_CONSTANT LITFOG_REAL litfog_scattering_depth_step = LITFOG_REAL(0.5649643735);  // ln(10 / 0.02) / 11
LITFOG_CONSTANT LITFOG_REAL litfog_least_scattering_angle = LITFOG_REAL(0.00349065850);  // 0.2 degrees
LITFOG_CONSTANT LITFOG_REAL litfog_scattering_angle_step = LITFOG_REAL(0.4001407);  // ln(180 / 0.2) / 17

// M d^-2 of a lamp of 1 / r^2 in endless fog of density d, at an optical depth from the lamp and an angle between the ray
// and the direction to the lamp. Depths and angles below the table's count as its first. Beyond its last depth the light
// falls as that of diffusion does, by 1 / depth.
LITFOG_REAL litfog_scattered_at(LITFOG_REAL depth, LITFOG_REAL angle) {
  LITFOG_REAL row = log(max(depth / litfog_least_scattering_depth, LITFOG_REAL(1.0))) / litfog_scattering_depth_step;
  LITFOG_REAL column = log(max(angle / litfog_least_scattering_angle, LITFOG_REAL(1.0))) / litfog_scattering_angle_step;
  LITFOG_REAL beyond = max(row - LITFOG_REAL(11.0), LITFOG_REAL(0.0)) * litfog_scattering_depth_step;
  return exp(litfog_scattering_log(row, column) - beyond);
}

// M, over the lamp's effective intensity, that a point on the ray receives from there on, in endless fog of the density
// between lamp and point. The point is at a distance along the ray from the closest approach.
LITFOG_REAL litfog_scattered_from(LitfogAirlight air, LITFOG_REAL along) {
  LITFOG_REAL density =
      air.density + air.layer_scale * litfog_mean_density(air.lamp_height, litfog_airlight_height(air, along));
  LITFOG_REAL depth = density * litfog_airlight_range(air, along);
  return density * density * litfog_scattered_at(depth, atan(air.offset, -along));
}

// M of a point lamp along a ray of exp fog, over the lamp's effective intensity: what the eye would receive from endless
// fog without what comes from beyond the ray's end.
LITFOG_REAL litfog_multiple_scattering(LitfogAirlight air) {
  LITFOG_REAL all = litfog_scattered_from(air, -air.approach);
  if (!(air.ray_length < litfog_far)) return all;
  LITFOG_REAL end = air.ray_length - air.approach;
  LITFOG_REAL mean = air.density + air.layer_scale * litfog_mean_density(litfog_airlight_height(air, -air.approach),
                                                                         litfog_airlight_height(air, end));
  return max(all - exp(-mean * air.ray_length) * litfog_scattered_from(air, end), LITFOG_REAL(0.0));
}

#undef LITFOG_REAL
#undef LITFOG_CONSTANT

#endif
