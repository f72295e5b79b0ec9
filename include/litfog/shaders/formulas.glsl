// SPDX-License-Identifier: Apache-2.0
// litfog: the scalar formulas of the model, compiled as they stand by C++ (litfog/formulas.h, any scalar type) and by
// GLSL.
// The includer defines Real, LITFOG_FUNCTION and litfog_expm1. Metres, 1/m, cosines.

// C + L r + Q r^2
LITFOG_FUNCTION Real litfog_denominator(Real range, Real constant, Real linear, Real quadratic) {
  return constant + range * (linear + range * quadratic);
}

// Range attenuation min(1, 1 / (C + L r + Q r^2))  (Hales 2004)
LITFOG_FUNCTION Real litfog_attenuation(Real range, Real constant, Real linear, Real quadratic) {
  Real denominator = litfog_denominator(range, constant, linear, quadratic);
  return denominator > Real(1.0) ? Real(1.0) / denominator : Real(1.0);
}

// Optical depth of exp fog, d r, and of exp2 fog, (d r)^2
LITFOG_FUNCTION Real litfog_depth_exp(Real range, Real density) { return density * range; }
LITFOG_FUNCTION Real litfog_depth_exp2(Real range, Real density) { return (density * range) * (density * range); }

// 1 - e^-depth without cancellation
LITFOG_FUNCTION Real litfog_opacity(Real depth) { return -litfog_expm1(-depth); }

// Cosine cone: cos^S u inside the half angle, 0 outside  (Hales 2004)
LITFOG_FUNCTION Real litfog_cosine_cone(Real cos_angle, Real cos_half_angle, Real exponent) {
  return cos_angle > cos_half_angle ? pow(cos_angle, exponent) : Real(0.0);
}

// Dual cone: smoothstep from the outer to the inner cosine  (Cg Tutorial 5.5.3)
LITFOG_FUNCTION Real litfog_smoothstep_cone(Real cos_angle, Real cos_inner, Real cos_outer) {
  if (cos_angle >= cos_inner) return Real(1.0);  // first, for the cosines of a narrow cone may be equal
  if (cos_angle <= cos_outer) return Real(0.0);
  Real t = (cos_angle - cos_outer) / (cos_inner - cos_outer);
  return t * t * (Real(3.0) - Real(2.0) * t);
}
