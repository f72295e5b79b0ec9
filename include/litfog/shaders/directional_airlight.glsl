// SPDX-License-Identifier: Apache-2.0
// litfog: a directional light, such as the sun or the moon, in exp fog (not exp2); single scattering. It adds
// litfog_airlight_unit() * colour * litfog_directional_airlight() to a picture. litfog_directional_factor() dims its
// light on surfaces. GLSL includes this file like any other; C++ takes the same text in
// src/airlight/directional_airlight.cpp.
//
// The fog is level, so along a ray the depth of the light's leg changes in proportion to the depth t of the eye's leg.
// With x the sum of both and D the ray's end, the airlight for any density over height is
//   phase * integral of e^-x dt = phase * t(D) * (e^-x(0) - e^-x(D)) / (x(D) - x(0)),
// the slab of Subrahmanyan Chandrasekhar 1960, "Radiative Transfer", with its sources along the light. The light enters
// at a top (Atmosphere::light_top). Above it, uniform fog still lies on all rays except those to the sky; there the
// light has no leg, and a ray is split where it crosses the top.

#ifndef LITFOG_DIRECTIONAL_AIRLIGHT_GLSL
#define LITFOG_DIRECTIONAL_AIRLIGHT_GLSL

#ifndef __cplusplus
#include "litfog/shaders/fog.glsl"

#define LITFOG_REAL float
#define LITFOG_FUNCTION
#endif

// Depth of the fog from a height to a light, at most 1e30, which stands for infinity.
//
// density  of the fog without layers, 1/m
// slope    sine of the light's elevation; fog without layers has no bottom and keeps out light from below
// top      metres: Atmosphere::light_top()
LITFOG_FUNCTION LITFOG_REAL litfog_depth_to_light(LITFOG_REAL density, LITFOG_REAL height, LITFOG_REAL slope,
                                                  LITFOG_REAL top) {
  LITFOG_REAL endless = LITFOG_REAL(1.0e30);
  if (slope < LITFOG_REAL(0.0)) {
    return density > LITFOG_REAL(0.0) ? endless : litfog_profile_depth_to_sky(height, slope, endless);
  }
  if (height >= top) return LITFOG_REAL(0.0);
  LITFOG_REAL column = density * (top - height);
  if (litfog_knot_count() > 0) column += litfog_profile_column(height, top);
  if (column == LITFOG_REAL(0.0)) return LITFOG_REAL(0.0);
  return slope > LITFOG_REAL(0.0) ? min(column / slope, endless) : endless;
}

// Depth of the fog along a line between two heights, finite.
LITFOG_FUNCTION LITFOG_REAL litfog_depth_between(LITFOG_REAL density, LITFOG_REAL height_a, LITFOG_REAL height_b,
                                                 LITFOG_REAL range) {
  return min((density + litfog_mean_density(height_a, height_b)) * range, LITFOG_REAL(1.0e29));
}

// Mean of e^-x between two x >= 0; 0 if one stands for infinity, because then at most the other end is lit.
LITFOG_FUNCTION LITFOG_REAL litfog_mean_factor(LITFOG_REAL a, LITFOG_REAL b) {
  if (max(a, b) >= LITFOG_REAL(1.0e30)) return LITFOG_REAL(0.0);
  LITFOG_REAL rise = abs(b - a);
  LITFOG_REAL mean = rise > LITFOG_REAL(1.0e-30) ? -litfog_expm1(-rise) / rise : LITFOG_REAL(1.0);
  return exp(-min(a, b)) * mean;
}

// Airlight along a ray, divided by the phase function, with the arguments of litfog_depth_to_light().
//
// rise   sine of the ray's elevation
// range  metres along it, finite
LITFOG_FUNCTION LITFOG_REAL litfog_directional_scattering(LITFOG_REAL density, LITFOG_REAL height, LITFOG_REAL rise,
                                                          LITFOG_REAL range, LITFOG_REAL slope, LITFOG_REAL top) {
  LITFOG_REAL climb = rise * range;
  LITFOG_REAL end = height + climb;
  LITFOG_REAL at_eye = litfog_depth_to_light(density, height, slope, top);
  LITFOG_REAL leg_at_end = litfog_depth_to_light(density, end, slope, top);
  if (slope < LITFOG_REAL(0.0) || (height < top) == (end < top)) {
    LITFOG_REAL whole = litfog_depth_between(density, height, end, range);
    return whole * litfog_mean_factor(at_eye, whole + leg_at_end);
  }
  LITFOG_REAL before = litfog_depth_between(density, height, top, (top - height) / climb * range);
  LITFOG_REAL beyond = litfog_depth_between(density, top, end,
                                            max(((height - top) + climb) / climb, LITFOG_REAL(0.0)) * range);
  return before * litfog_mean_factor(at_eye, before) +
         beyond * litfog_mean_factor(before, before + beyond + leg_at_end);
}

#undef LITFOG_FUNCTION
#undef LITFOG_REAL

#ifndef __cplusplus
// Density of the fog without layers, 1/m.
float litfog_directional_density() { return min(litfog_fog.x, LITFOG_DENSEST_FOG); }

// Fraction of the light that reaches a height.
float litfog_directional_factor(float height, vec3 to_light, float top) {
  return exp(-litfog_depth_to_light(litfog_directional_density(), height, to_light.y, top));
}

// Airlight along a ray from the eye. Largest error: 2e-5 of the phase function's value.
//
// direction  the ray's, unit
// range      metres along it, finite: to the surface or the end of the fog
// to_light   unit
float litfog_directional_airlight(vec3 eye, vec3 direction, float range, vec3 to_light, float top) {
  vec3 turn = direction - to_light;
  return litfog_phase(litfog_fog_phase(), 0.5 * dot(turn, turn)) *
         litfog_directional_scattering(litfog_directional_density(), eye.y, direction.y, range, to_light.y, top);
}
#endif

#endif
