// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "litfog/value_error.h"

namespace litfog {

/// One lobe of a phase function over its isotropic value, at the cosine mu of the angle of scattering:
///   (1 - g^2) / (1 + g^2 - 2 g mu)^(3/2) * (1 + alpha mu^2) / (1 + alpha (1 + 2 g^2) / 3)
/// (Bruce Draine 2003, "Scattering by Interstellar Dust Grains", equation 4). alpha = 0 is Henyey and Greenstein's
/// function, alpha = 1 Cornette and Shanks's, and g = 0 with alpha = 1 Rayleigh's.
struct PhaseLobe {
  double asymmetry = 0;  ///< g, (-1, 1): 0 is isotropic where alpha is 0, near 1 scatters straight ahead
  double alpha = 0;      ///< [0, 1e6]

  friend bool operator==(const PhaseLobe&, const PhaseLobe&) = default;
};

/// Diameters of droplets, micrometres, for which Phase::droplets is stated.
inline constexpr double kSmallestDroplets = 5, kLargestDroplets = 50;

/// The phase function of a fog: how the light that it scatters is spread over angles. It is a sum of two lobes, over
/// the value of isotropic fog. All that depends on its shape is asked of the functions below, and in shaders of
/// litfog/shaders/phase.glsl, whose text they share.
struct Phase {
  PhaseLobe first = {};
  PhaseLobe second = {};
  double weight = 1;  ///< [0, 1], of the first lobe; the second has the rest

  /// Louis Henyey and Jesse Greenstein 1941, "Diffuse Radiation in the Galaxy".
  static Phase henyey_greenstein(double asymmetry) { return {.first = {.asymmetry = asymmetry}}; }

  /// Fog of water droplets of a diameter (Johannes Jendersie and Eugene d'Eon 2023, "An Approximate Mie Scattering
  /// Function for Fog and Cloud Rendering", equations 4 to 7).
  ///
  /// micrometres  [kSmallestDroplets, kLargestDroplets]
  /// throws       std::invalid_argument naming field, value and rule
  static Phase droplets(double micrometres);

  friend bool operator==(const Phase&, const Phase&) = default;
};

/// Diameter of the droplets that have a phase function, micrometres. It is found if each parameter is within 5e-7 of
/// theirs, relatively, and never if one is farther than 1e-6.
std::optional<double> droplet_diameter(const Phase& phase);

/// What is wrong with a lobe, or nothing.
std::optional<ValueError> find_error(const PhaseLobe& lobe);
/// What is wrong with a phase function, or nothing. The functions below take those with which nothing is.
std::optional<ValueError> find_error(const Phase& phase);

inline constexpr const char* kAsymmetryRule = "must be in (-1, 1)";

bool is_isotropic(const Phase& phase);

/// Its value at a cosine of the angle of scattering, [-1, 1]: 1 is straight ahead, -1 straight back.
double phase_at(const Phase& phase, double cosine);

/// Largest relative error of largest_phase for a phase function of one lobe, |g| <= 0.99: straight back, 1 - cosine has
/// no more digits. Between -1 and 1 it is 1e-14.
inline constexpr double kLargestPhaseMaxError = 1e-11;

/// Upper bound of its value between two cosines: the sum of both lobes' largest values there, which is the largest
/// value itself where one has no weight or both rise with the cosine. Of all cosines with alpha = 0 a lobe's largest
/// value is (1 + |g|) / (1 - |g|)^2.
///
/// lowest, highest  [-1, 1], lowest <= highest
/// max error        kLargestPhaseMaxError                                                              (phase_test.cpp)
double largest_phase(const Phase& phase, double lowest = -1, double highest = 1);

/// Mean cosine of the angle of scattering (Bruce Draine 2003, "Scattering by Interstellar Dust Grains. I. Optical and
/// Ultraviolet", equation 5).
double mean_cosine(const Phase& phase);

}  // namespace litfog
