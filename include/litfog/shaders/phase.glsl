// SPDX-License-Identifier: Apache-2.0
// litfog: the phase function, which states how the light that fog scatters is spread over angles. Its values are over
// that of isotropic fog. All that depends on its shape is asked here, so that another lobe changes this file and
// litfog/phase.h alone. GLSL includes this file like any other; C++ takes the same text through src/model/phase_text.h.

#ifndef LITFOG_PHASE_GLSL
#define LITFOG_PHASE_GLSL

#ifndef __cplusplus
#include "litfog/shaders/expm1.glsl"
#define LITFOG_REAL float
#define LITFOG_FUNCTION

struct LitfogPhase {
  float asymmetry;  // g of Henyey and Greenstein, (-1, 1); 0 is isotropic
};

const LitfogPhase litfog_isotropic = LitfogPhase(0.0);
#endif

LITFOG_FUNCTION bool litfog_is_isotropic(LitfogPhase phase) { return phase.asymmetry == LITFOG_REAL(0.0); }

// The phase function at a cosine of the angle of scattering: 1 straight ahead, -1 straight back (Louis Henyey and Jesse
// Greenstein 1941, "Diffuse Radiation in the Galaxy").
LITFOG_FUNCTION LITFOG_REAL litfog_phase(LitfogPhase phase, LITFOG_REAL cosine) {
  LITFOG_REAL square = phase.asymmetry * phase.asymmetry;
  LITFOG_REAL base = LITFOG_REAL(1.0) + square - LITFOG_REAL(2.0) * phase.asymmetry * cosine;
  return (LITFOG_REAL(1.0) - square) / (base * sqrt(base));
}

// The largest value between two cosines, lowest <= highest. The function rises with g times the cosine, of which no
// digits cancel here at the peak: the base is the sum (1 - |g|)^2 + 2 |g| (1 - cosine), for g < 0 with -cosine.
LITFOG_FUNCTION LITFOG_REAL litfog_largest_phase(LitfogPhase phase, LITFOG_REAL lowest, LITFOG_REAL highest) {
  LITFOG_REAL size = abs(phase.asymmetry);
  LITFOG_REAL rest = LITFOG_REAL(1.0) - size;
  LITFOG_REAL nearest_to_peak = phase.asymmetry < LITFOG_REAL(0.0) ? -lowest : highest;
  LITFOG_REAL base = rest * rest + LITFOG_REAL(2.0) * size * (LITFOG_REAL(1.0) - nearest_to_peak);
  return (LITFOG_REAL(1.0) + size) * rest / (base * sqrt(base));
}

// Optical depths of fog that a phase function makes up for: at least the logarithm of its largest value over the angles
// up to 90 degrees, and over those beyond. (1 + |g|) / (1 - |g|)^2 is at most e^(6 |g|) for |g| <= 0.9.
LITFOG_FUNCTION LITFOG_REAL litfog_forward_depths(LitfogPhase phase) {
  return LITFOG_REAL(6.0) * max(phase.asymmetry, LITFOG_REAL(0.0));
}
LITFOG_FUNCTION LITFOG_REAL litfog_backward_depths(LitfogPhase phase) {
  return LITFOG_REAL(6.0) * max(-phase.asymmetry, LITFOG_REAL(0.0));
}

// How many nodes the airlight takes where the phase function is not isotropic.
LITFOG_FUNCTION LITFOG_REAL litfog_phase_nodes(LitfogPhase phase) {
  return abs(phase.asymmetry) > LITFOG_REAL(0.5) ? LITFOG_REAL(64.0) : LITFOG_REAL(40.0);
}

#undef LITFOG_FUNCTION
#undef LITFOG_REAL

#endif
