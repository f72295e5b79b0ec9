// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "litfog/value_error.h"

namespace litfog {

/// The phase function of a fog: how the light that it scatters is spread over angles, by Henyey and Greenstein 1941,
/// "Diffuse Radiation in the Galaxy". Its values are over that of isotropic fog. All that depends on its shape is asked
/// of the functions below, and in the shaders of litfog/shaders/phase.glsl, whose text they share.
template <typename Real>
struct BasicPhase {
  Real asymmetry = 0;  ///< g, (-1, 1): 0 is isotropic, near 1 scatters straight ahead, near -1 straight back

  friend bool operator==(const BasicPhase&, const BasicPhase&) = default;
};
using Phase = BasicPhase<double>;
using PhaseF = BasicPhase<float>;

inline constexpr const char* kAsymmetryRule = "must be in (-1, 1)";

/// What is wrong with a phase function, or nothing. The functions below take those with which nothing is.
std::optional<ValueError> find_error(const Phase& phase);

bool is_isotropic(const Phase& phase);

/// Its value at a cosine of the angle of scattering, [-1, 1]: 1 is straight ahead, -1 straight back.
double phase_at(const Phase& phase, double cosine);

/// Largest relative error of largest_phase.
inline constexpr double kLargestPhaseMaxError = 1e-15;

/// Its largest value between two cosines: over all angles (1 + |g|) / (1 - |g|)^2, which is 1 in isotropic fog.
///
/// lowest, highest  [-1, 1], lowest <= highest
/// max error        kLargestPhaseMaxError                                                              (phase_test.cpp)
double largest_phase(const Phase& phase, double lowest = -1, double highest = 1);

/// The phase function in floats, as shaders take it. What rounds to an asymmetry of 1 becomes the float next to it.
PhaseF to_floats(const Phase& phase);

}  // namespace litfog
