// SPDX-License-Identifier: Apache-2.0
// How much a display brightens airlight that is left out.

uniform float exposure_gain;

const float darkest_slope = 12.92;  // slope of sRGB (IEC 61966-2-1) at black

// Slope of sRGB at an exposed linear value, which is shown in any case. No tone curve makes it steeper.
vec3 display_slope(vec3 linear) {
  return exposure_gain *
         min(vec3(darkest_slope), 0.4396 * pow(max(exposure_gain * linear, vec3(1.0e-4)), vec3(-0.5833)));
}
