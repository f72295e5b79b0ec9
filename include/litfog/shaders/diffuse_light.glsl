// SPDX-License-Identifier: Apache-2.0
// litfog: the irradiance of surfaces by light from many directions. Shared with C++ like formulas.glsl.

#ifndef LITFOG_DIFFUSE_LIGHT_GLSL
#define LITFOG_DIFFUSE_LIGHT_GLSL

#ifndef __cplusplus
#include "litfog/shaders/expm1.glsl"  // the precision of floats
#define LITFOG_REAL float
#define LITFOG_FUNCTION
#endif

// Irradiance of a surface from the light's fluence and flow. Two things are exact: the mean over all orientations of
// the surface, all / 4, and the difference between its two sides, facing. In between, radiance is taken as uniform plus
// a peak about the flow. The width of that peak is fitted to the light around a lamp in fog, all orders of scattering
// together, for isotropic fog, HG 0.79 and 0.93 and droplets of 8.4 and 17.
//
// all     integral of the radiance over all directions
// flow    length of the integral of the radiance times the direction
// facing  that integral's component into the surface
LITFOG_FUNCTION LITFOG_REAL litfog_diffuse_irradiance(LITFOG_REAL all, LITFOG_REAL flow, LITFOG_REAL facing) {
  LITFOG_REAL even = max(all - flow, LITFOG_REAL(1.0e-6) * all);
  LITFOG_REAL width =
      LITFOG_REAL(0.5) * even / max(flow + LITFOG_REAL(0.15) * even, LITFOG_REAL(1.0e-30));  // over the flow
  LITFOG_REAL edge = sqrt(LITFOG_REAL(1.0) + width * width);
  LITFOG_REAL peak = LITFOG_REAL(0.5) * (facing + sqrt(facing * facing + width * width * flow * flow));
  LITFOG_REAL mean_peak = LITFOG_REAL(0.25) * flow *
                          (edge + width * width * log((LITFOG_REAL(1.0) + edge) / max(width, LITFOG_REAL(1.0e-6))));
  return peak + LITFOG_REAL(0.25) * all - mean_peak;
}

#undef LITFOG_FUNCTION
#undef LITFOG_REAL

#endif
