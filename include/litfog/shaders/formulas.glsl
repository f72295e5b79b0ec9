// SPDX-License-Identifier: Apache-2.0
// litfog: the scalar formulas of the model in metres, 1/m and cosines. GLSL includes this file like any other. C++
// takes the same text through litfog/formulas.h, which defines LITFOG_REAL and LITFOG_FUNCTION first and drops the
// prefix litfog_ of every function. So no variable here may have a function's name without the prefix.

#ifndef LITFOG_FORMULAS_GLSL
#define LITFOG_FORMULAS_GLSL

#ifndef __cplusplus
#include "litfog/shaders/expm1.glsl"
#define LITFOG_REAL float
#define LITFOG_FUNCTION
#endif

#define LITFOG_DENSEST_FOG 1.0e6  // 1/m: shaders take denser fog as this. It is a visibility of micrometres.

// C + L r + Q r^2
LITFOG_FUNCTION LITFOG_REAL litfog_denominator(LITFOG_REAL range, LITFOG_REAL constant, LITFOG_REAL linear,
                                               LITFOG_REAL quadratic) {
  return constant + range * (linear + range * quadratic);
}

// Range attenuation min(1, 1 / (C + L r + Q r^2))  (Steven Hales 2004, "Realtime Pixel Lighting Using Fragment
// Programs")
LITFOG_FUNCTION LITFOG_REAL litfog_attenuation(LITFOG_REAL range, LITFOG_REAL constant, LITFOG_REAL linear,
                                               LITFOG_REAL quadratic) {
  LITFOG_REAL divisor = litfog_denominator(range, constant, linear, quadratic);
  return divisor > LITFOG_REAL(1.0) ? LITFOG_REAL(1.0) / divisor : LITFOG_REAL(1.0);
}

// Optical depth of exp fog, d r, and of exp2 fog, (d r)^2
LITFOG_FUNCTION LITFOG_REAL litfog_depth_exp(LITFOG_REAL range, LITFOG_REAL density) { return density * range; }
LITFOG_FUNCTION LITFOG_REAL litfog_depth_exp2(LITFOG_REAL range, LITFOG_REAL density) {
  return (density * range) * (density * range);
}

// Whether a fog mode, a number of FogMode (litfog/fog.h), is exp; otherwise it is exp2
LITFOG_FUNCTION bool litfog_is_exp(LITFOG_REAL mode) { return mode == LITFOG_REAL(0.0); }

// 1 - e^-depth without cancellation
LITFOG_FUNCTION LITFOG_REAL litfog_opacity(LITFOG_REAL depth) { return -litfog_expm1(-depth); }

#undef LITFOG_FUNCTION
#undef LITFOG_REAL

#endif
