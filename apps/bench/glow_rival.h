// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "litfog/phase.h"

namespace litfog::bench {

/// The glow of a point lamp in endless uniform fog of albedo 1 as others compute it: the light of all orders of
/// scattering over I d^2, in the unit of airlight(), for the law a(r) = I / r^2 in fog of density d.
///
/// depth        optical, between lamp and eye, > 0
/// angle        radians, between the ray and the direction to the lamp, (0, pi]
/// mean_cosine  of the angle of scattering, [0, 1): all that the first two know of a phase function

/// Srinivasa Narasimhan and Shree Nayar 2003, "Shedding Light on the Weather": a series of Legendre polynomials, the
/// atmospheric point spread function. It is scaled so that its net flux through a sphere around the lamp is the lamp's
/// own, which fog of albedo 1 leaves as it is. It has the lamp's direct light in it.
///
/// returns  NaN up to a depth of 1, where the series does not converge
double apsf_glow(double mean_cosine, double depth, double angle);

/// One Gaussian over the angle: the part 1 - e^-depth of the lamp's light that is scattered, spread as the theory of
/// small angles has it, by a mean square angle of 2/3 (1 - mean_cosine) depth for all of the light. It is the simplest
/// form of what Simon Premože, Michael Ashikhmin, Jerry Tessendorf, Ravi Ramamoorthi and Shree Nayar 2004, "Practical
/// Rendering of Multiple Scattering Effects in Participating Media", blur a scene's light with.
double gaussian_glow(double mean_cosine, double depth, double angle);

/// Octaves of single scattering, as engines fake the higher orders (Magnus Wrenninge, Chris Kulla and Viktor Lundqvist
/// 2013, "Oz: The Great and Volumetric", with a = b = c = 1/2): fog that takes and scatters half as much as that of the
/// octave before, with lobes of half the asymmetry. Three octaves, the first of which is the single scattering, in
/// equal steps from the eye to where the fog leaves 1e-4.
double octave_glow(const Phase& phase, double depth, double angle, int steps);

}  // namespace litfog::bench
