// SPDX-License-Identifier: Apache-2.0
// litfog: expm1, which GLSL lacks. Every other file of litfog that has functions includes this one. In GLSL ES it
// sets the default precision of float and int to highp.

#ifndef LITFOG_EXPM1_GLSL
#define LITFOG_EXPM1_GLSL

#ifdef GL_ES
precision highp float;
precision highp int;
#endif

// e^x - 1 without cancellation. Near 0 it is x / (h coth h - h) with h = x / 2 and the series of h coth h.
// Largest error: 4 ulp of float if -0.6875 <= x <= 0, the driver's error of exp below that; not stated above 0.
float litfog_expm1(float x) {
  if (abs(x) > 0.6875) return exp(x) - 1.0;
  float x2 = x * x;
  float h_coth_h = 1.0 + x2 * (1.0 / 12.0 + x2 * (-1.0 / 720.0 + x2 * (1.0 / 30240.0)));
  return x / (h_coth_h - 0.5 * x);
}

#endif
