// SPDX-License-Identifier: Apache-2.0
// litfog: what formulas.glsl wants of its includer, for GLSL 3.30 and later.

#define Real float
#define LITFOG_FUNCTION

// e^x - 1 for x <= 0 without cancellation, which GLSL lacks. Near 0 from x / (h coth h - h), h = x / 2, with the series
// of h coth h; error 4 ulp of float there, that of the driver's exp beyond.
float litfog_expm1(float x) {
  if (x < -0.6875) return exp(x) - 1.0;
  float x2 = x * x;
  float h_coth_h = 1.0 + x2 * (1.0 / 12.0 + x2 * (-1.0 / 720.0 + x2 * (1.0 / 30240.0)));
  return x / (h_coth_h - 0.5 * x);
}
