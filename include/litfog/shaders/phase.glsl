// SPDX-License-Identifier: Apache-2.0
// litfog: the phase function, the angular distribution of the light that fog scatters: a sum of two lobes, relative to
// isotropic fog. Only this file and litfog/phase.h know its shape, so another lobe changes only them. GLSL includes
// this file like any other; C++ takes the same text through src/model/phase_text.h.
//
// Scattering angles are given by their versine, 1 - cosine: 0 is straight ahead, 2 straight back. A float's cosine has
// too few digits for the peak of a narrow lobe.
//
// A program for isotropic fog only, or for other fog only, may define LITFOG_ISOTROPIC as 1 or 0 before the first
// include of litfog; compilers then drop the other case.

#ifndef LITFOG_PHASE_GLSL
#define LITFOG_PHASE_GLSL

#ifndef __cplusplus
#include "litfog/shaders/expm1.glsl"  // the precision of floats
#define LITFOG_REAL float
#define LITFOG_FUNCTION

// A lobe times its weight, with terms that do not depend on the angle. litfog_packed_lobe() makes it from g and alpha.
struct LitfogPhaseLobe {
  float base;   // (1 - |g|)^2
  float slope;  // 2 g
  float scale;  // weight (1 - g^2) / (1 + alpha (1 + 2 g^2) / 3)
  float alpha;
};

struct LitfogPhase {
  LitfogPhaseLobe first;
  LitfogPhaseLobe second;
};

const LitfogPhase litfog_isotropic =
    LitfogPhase(LitfogPhaseLobe(1.0, 0.0, 1.0, 0.0), LitfogPhaseLobe(1.0, 0.0, 0.0, 0.0));
#endif

LITFOG_FUNCTION LitfogPhaseLobe litfog_packed_lobe(LITFOG_REAL asymmetry, LITFOG_REAL alpha, LITFOG_REAL weight) {
  LITFOG_REAL rest = LITFOG_REAL(1.0) - abs(asymmetry);
  LITFOG_REAL of_alpha =
      LITFOG_REAL(1.0) + alpha * (LITFOG_REAL(1.0) + LITFOG_REAL(2.0) * asymmetry * asymmetry) / LITFOG_REAL(3.0);
  LitfogPhaseLobe lobe;
  lobe.base = rest * rest;
  lobe.slope = LITFOG_REAL(2.0) * asymmetry;
  lobe.scale = weight * rest * (LITFOG_REAL(1.0) + abs(asymmetry)) / of_alpha;
  lobe.alpha = alpha;
  return lobe;
}

LITFOG_FUNCTION bool litfog_is_isotropic(LitfogPhase phase) {
#ifdef LITFOG_ISOTROPIC
  return LITFOG_ISOTROPIC == 1;
#else
  return phase.first.slope == LITFOG_REAL(0.0) && phase.first.alpha == LITFOG_REAL(0.0) &&
         phase.second.slope == LITFOG_REAL(0.0) && phase.second.alpha == LITFOG_REAL(0.0);
#endif
}

// Draine's function (litfog/phase.h). For g >= 0, 1 + g^2 - 2 g cosine is (1 - g)^2 + 2 g versine, which does not
// cancel; a lobe with g < 0 is mirrored.
LITFOG_FUNCTION LITFOG_REAL litfog_phase_lobe(LitfogPhaseLobe lobe, LITFOG_REAL versine) {
  LITFOG_REAL cosine = LITFOG_REAL(1.0) - versine;
  LITFOG_REAL from_peak = lobe.slope < LITFOG_REAL(0.0) ? LITFOG_REAL(2.0) - versine : versine;
  LITFOG_REAL base = lobe.base + abs(lobe.slope) * from_peak;
  return lobe.scale * (LITFOG_REAL(1.0) + lobe.alpha * cosine * cosine) / (base * sqrt(base));
}

LITFOG_FUNCTION LITFOG_REAL litfog_phase(LitfogPhase phase, LITFOG_REAL versine) {
  return litfog_phase_lobe(phase.first, versine) + litfog_phase_lobe(phase.second, versine);
}

// The weight of a second lobe with alpha = 0: for droplets, the lobe that hardly deflects light.
LITFOG_FUNCTION LITFOG_REAL litfog_second_weight(LitfogPhase phase) {
  LITFOG_REAL rest = sqrt(phase.second.base);
  return phase.second.scale / (rest * (LITFOG_REAL(2.0) - rest));
}

// An upper bound between two versines, lowest <= highest: each lobe falls and then rises with the versine, or does only
// one of the two, so its largest value lies at an end. For g >= 0 the derivative by the cosine c has the sign of
// -alpha g c^2 + 2 alpha (1 + g^2) c + 3 g, whose larger root is at least (1 + g^2) / g >= 2: within [-1, 1] it changes
// from negative to positive once or not at all. For g < 0 the lobe is mirrored.
LITFOG_FUNCTION LITFOG_REAL litfog_largest_phase(LitfogPhase phase, LITFOG_REAL lowest, LITFOG_REAL highest) {
  return max(litfog_phase_lobe(phase.first, lowest), litfog_phase_lobe(phase.first, highest)) +
         max(litfog_phase_lobe(phase.second, lowest), litfog_phase_lobe(phase.second, highest));
}

// Optical depths that a phase function makes up for, at angles up to 90 degrees and beyond: at least the logarithm of
// its largest value there, without alpha's part. (1 + |g|) / (1 - |g|)^2 is at most e^(10 |g|) for |g| <= 0.99 and
// e^(14 |g|) for droplets.
LITFOG_FUNCTION LITFOG_REAL litfog_forward_depths(LitfogPhase phase) {
  return LITFOG_REAL(7.0) * max(max(phase.first.slope, phase.second.slope), LITFOG_REAL(0.0));
}
LITFOG_FUNCTION LITFOG_REAL litfog_backward_depths(LitfogPhase phase) {
  return LITFOG_REAL(5.0) * max(max(-phase.first.slope, -phase.second.slope), LITFOG_REAL(0.0));
}

#undef LITFOG_FUNCTION
#undef LITFOG_REAL

#endif
