// SPDX-License-Identifier: Apache-2.0
// litfog: the profiles of cones as lights store them (LitfogInstance, LitfogAirlight): a number and two parameters, x
// and y. Shared with C++ like formulas.glsl. Only this file and litfog/cone.h know the profiles; all others ask them.

#ifndef LITFOG_CONE_PROFILE_GLSL
#define LITFOG_CONE_PROFILE_GLSL

#ifndef __cplusplus
#include "litfog/shaders/expm1.glsl"
#define LITFOG_REAL float
#define LITFOG_FUNCTION
#endif

// The numbers of ConeProfile. A light with any other number is dark.
#define LITFOG_PROFILE_NONE 0.0        // a point light
#define LITFOG_PROFILE_COSINE 1.0      // x cos half angle, y exponent
#define LITFOG_PROFILE_SMOOTHSTEP 2.0  // x cos outer, y cos inner
// Above all of them. The including program evaluates it (light.glsl).
#define LITFOG_PROFILE_COOKIE 255.0

// Cosine cone: cos^S u inside the half angle, 0 outside  (Hales 2004)
LITFOG_FUNCTION LITFOG_REAL litfog_cosine_cone(LITFOG_REAL cos_angle, LITFOG_REAL cos_half_angle,
                                               LITFOG_REAL exponent) {
  return cos_angle > cos_half_angle ? pow(cos_angle, exponent) : LITFOG_REAL(0.0);
}

// Dual cone: smoothstep from the outer to the inner cosine  (Randima Fernando and Mark Kilgard 2003, "The Cg Tutorial",
// section 5.5.2)
LITFOG_FUNCTION LITFOG_REAL litfog_smoothstep_cone(LITFOG_REAL cos_angle, LITFOG_REAL cos_inner,
                                                   LITFOG_REAL cos_outer) {
  if (cos_angle >= cos_inner) return LITFOG_REAL(1.0);  // first, because a narrow cone's cosines may be equal
  if (cos_angle <= cos_outer) return LITFOG_REAL(0.0);
  LITFOG_REAL t = (cos_angle - cos_outer) / (cos_inner - cos_outer);
  return t * t * (LITFOG_REAL(3.0) - LITFOG_REAL(2.0) * t);
}

// Whether a light has a cone and so is dark beyond the cosine x: it is no point light and has no cookie.
LITFOG_FUNCTION bool litfog_has_cone(LITFOG_REAL profile) {
  return profile != LITFOG_REAL(LITFOG_PROFILE_NONE) && profile != LITFOG_REAL(LITFOG_PROFILE_COOKIE);
}

// Fraction of the axial intensity at an angle.
LITFOG_FUNCTION LITFOG_REAL litfog_cone_at(LITFOG_REAL profile, LITFOG_REAL cos_angle, LITFOG_REAL x, LITFOG_REAL y) {
  if (profile == LITFOG_REAL(LITFOG_PROFILE_COSINE)) return litfog_cosine_cone(cos_angle, x, y);
  if (profile == LITFOG_REAL(LITFOG_PROFILE_SMOOTHSTEP)) return litfog_smoothstep_cone(cos_angle, y, x);
  return profile == LITFOG_REAL(LITFOG_PROFILE_NONE) ? LITFOG_REAL(1.0) : LITFOG_REAL(0.0);
}

// Whether a cone falls off from its axis and is cut off at x. With x = 0, litfog_cone_at() gives the uncut shape.
LITFOG_FUNCTION bool litfog_cone_is_cut_off(LITFOG_REAL profile) {
  return profile == LITFOG_REAL(LITFOG_PROFILE_COSINE);
}

// Cosine beyond which a cone is dark or, if it is cut off, below 1e-5 of its value at the cosine `brightest`.
LITFOG_FUNCTION LITFOG_REAL litfog_cone_end(LITFOG_REAL profile, LITFOG_REAL brightest, LITFOG_REAL x, LITFOG_REAL y) {
  if (!litfog_cone_is_cut_off(profile)) return x;
  return max(x, brightest * exp(LITFOG_REAL(-11.5) / max(y, LITFOG_REAL(0.1))));
}

// Whether y is the cosine of an edge within the cone, where it is not smooth.
LITFOG_FUNCTION bool litfog_cone_has_inner_edge(LITFOG_REAL profile) {
  return profile == LITFOG_REAL(LITFOG_PROFILE_SMOOTHSTEP);
}

// The square of the sine of a cone's half width: at half its axial intensity, or in the middle of its edge.
LITFOG_FUNCTION LITFOG_REAL litfog_cone_sine_squared(LITFOG_REAL profile, LITFOG_REAL x, LITFOG_REAL y) {
  if (litfog_cone_is_cut_off(profile)) return -litfog_expm1(LITFOG_REAL(-1.3862944) / max(y, LITFOG_REAL(0.05)));
  LITFOG_REAL cosine = LITFOG_REAL(0.5) * (x + y);
  return LITFOG_REAL(1.0) - cosine * cosine;
}

#undef LITFOG_FUNCTION
#undef LITFOG_REAL

#endif
