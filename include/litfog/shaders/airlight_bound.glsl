// SPDX-License-Identifier: Apache-2.0
// litfog: upper bounds for leaving out lamps whose airlight (airlight.glsl) is invisible. s is the distance from the
// eye, r the distance from the lamp; k is 1 if the lamp's leg is fogged. Callers add phase functions and cones.
// Shared with C++ like formulas.glsl.

#ifndef LITFOG_AIRLIGHT_BOUND_GLSL
#define LITFOG_AIRLIGHT_BOUND_GLSL

#ifndef __cplusplus
#include "litfog/shaders/formulas.glsl"
#define LITFOG_REAL float
#define LITFOG_FUNCTION
#endif

#define LITFOG_FAR_PEAK_ANGLE 0.15  // radians: litfog_far_peak_angle of far_airlight.glsl

// An upper bound of the fog's weight -f'(s) f(r)^k, 1/m, in fog of at most `density`. With x = d s and y = k d r,
// x + y (exp fog) or x^2 / 2 + y^2 (exp2 fog) must be at least its value at x = `seen` and y = `lit`. In exp fog the d
// of each leg may be that of the thinnest fog on it.
//
// Proof. In exp fog the weight is d e^(-x - y). In exp2 fog it is 2 d x e^(-x^2 - y^2), and 2 x e^(-x^2 / 2) <= 1.2131.
//
// On any ray s + r >= L, the distance from the eye to the lamp. For s + r = L, s^2 / 2 + r^2 is least at s = 2 L / 3
// and r = L / 3, where it is L^2 / 3: these two distances bound the weight everywhere.
// Depths above 80 count as 80, so that an endless light is also bounded.
LITFOG_FUNCTION LITFOG_REAL litfog_largest_fog_weight(LITFOG_REAL mode, LITFOG_REAL density, LITFOG_REAL seen,
                                                      LITFOG_REAL lit) {
  if (litfog_is_exp(mode)) return density * exp(-min(seen + lit, LITFOG_REAL(80.0)));
  LITFOG_REAL depth = LITFOG_REAL(0.5) * seen * seen + lit * lit;
  return density * (LITFOG_REAL(1.2131) * exp(-min(depth, LITFOG_REAL(80.0))));
}

// An upper bound of the attenuation's integral along a line `size` metres long, where the attenuation's denominator is
// D at the point nearest to the lamp. With m the larger of D and 1, the attenuation is at most 1 / m. Because
// D(r) >= D + Q x^2 at the distance x from that point, the integral is also at most
// - pi / sqrt(Q D) if D >= 1;
// - 4 / sqrt(Q) if D < 1: the integral of min(1, 1 / (Q x^2)), because the attenuation is at most 1;
// so at most 4 / sqrt(Q m) in either case.
LITFOG_FUNCTION LITFOG_REAL litfog_largest_attenuation_integral(LITFOG_REAL denominator, LITFOG_REAL quadratic,
                                                                LITFOG_REAL size) {
  LITFOG_REAL m = max(denominator, LITFOG_REAL(1.0));
  LITFOG_REAL integral = size / m;
  return quadratic > LITFOG_REAL(0.0) ? min(integral, LITFOG_REAL(4.0) / sqrt(quadratic * m)) : integral;
}

// An upper bound of the airlight along such a line, on which the fog's weight is at most `weight`; the weight's
// integral is at most 1.
LITFOG_FUNCTION LITFOG_REAL litfog_largest_airlight(LITFOG_REAL weight, LITFOG_REAL denominator, LITFOG_REAL quadratic,
                                                    LITFOG_REAL size) {
  return min(LITFOG_REAL(1.0) / max(denominator, LITFOG_REAL(1.0)),
             weight * litfog_largest_attenuation_integral(denominator, quadratic, size));
}

#undef LITFOG_FUNCTION
#undef LITFOG_REAL

#endif
