// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "litfog/phase.h"

namespace litfog::bench {

/// The glow of a point lamp in endless uniform fog of albedo 1 as others compute it: the light of all orders of
/// scattering over I d^2, in the unit of airlight(), for the law a(r) = I / r^2 in fog of density d.
///
/// depth        optical, between lamp and eye, > 0
/// angle        radians, between the ray and the direction to the lamp, (0, pi]
/// mean_cosine  of the phase function, [0, 1): the only property of it that the first two use

/// Srinivasa Narasimhan and Shree Nayar 2003, "Shedding Light on the Weather": a series of Legendre polynomials, the
/// atmospheric point spread function. It is scaled so that its net flux through a sphere around the lamp equals the
/// lamp's flux, which fog of albedo 1 conserves. It includes the lamp's direct light.
///
/// returns  NaN up to a depth of 1, where the series does not converge
double apsf_glow(double mean_cosine, double depth, double angle);

/// One Gaussian over the angle: the scattered fraction 1 - e^-depth of the lamp's light, spread by the small-angle
/// approximation with a mean square angle of 2/3 (1 - mean_cosine) depth for all of the light. The simplest form of the
/// blur by Simon Premože, Michael Ashikhmin, Jerry Tessendorf, Ravi Ramamoorthi and Shree Nayar 2004, "Practical
/// Rendering of Multiple Scattering Effects in Participating Media".
double gaussian_glow(double mean_cosine, double depth, double angle);

/// Octaves of single scattering, as engines fake the higher orders (Magnus Wrenninge, Chris Kulla and Viktor Lundqvist
/// 2013, "Oz: The Great and Volumetric", with a = b = c = 1/2): each octave halves the previous octave's extinction,
/// scattering and asymmetry. Three octaves, the first of which is single scattering, in equal steps from the eye to
/// where the transmittance is 1e-4.
double octave_glow(const Phase& phase, double depth, double angle, int steps);

}  // namespace litfog::bench
