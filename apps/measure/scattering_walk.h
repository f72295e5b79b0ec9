// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "litfog/airlight.h"

namespace litfog::measure {

/// A number found by chance.
struct Estimate {
  double value = 0;
  double error = 0;  ///< its standard error
};

/// Light that the fog scatters into the eye by the number of its scatterings, each in the unit of airlight(): times the
/// light's colour and airlight_unit() it is what a picture shows.
struct ScatteredLight {
  Estimate first;   ///< once: the airlight
  Estimate second;  ///< twice
  Estimate higher;  ///< twice and more often: M, what is missing in airlight()
};

/// A Lambertian ground, the horizontal plane at a height. Lamp and eye are above it.
struct Ground {
  double height = 0;  ///< metres
  double albedo = 0;  ///< [0, 1]
};

struct ScatteringWalk {
  std::uint64_t paths = 1 << 16;  ///< rounded up to a multiple of kScatteringBatches
  std::uint64_t seed = 1;
  std::size_t threads = 0;       ///< 0: all cores. The result does not depend on it.
  std::optional<Ground> ground;  ///< rays end there; a reflection counts as a scattering
};

/// Independent parts of the paths, from whose spread the standard error is.
inline constexpr std::size_t kScatteringBatches = 64;

/// All orders of scattering of a light along a ray, by a random walk from the eye (Monte Carlo), in exp fog with the
/// lamp's leg fogged. It is the reference of what litfog knows of them, and takes seconds.
///
/// Each path begins on the eye's ray, and goes on by the phase function and the law of free paths. At each of its
/// vertices light reaches it over one more scattering on a leg drawn for it, whose direction is drawn from the phase
/// function, towards the lamp or, for a spot, into the beam, and whose place on the leg is drawn by the angle at the
/// lamp (Christopher Kulla and Marcos Fajardo 2012, "Importance Sampling Techniques for Path Tracing in Participating
/// Media", section 3.1), weighted by the phase function. All ways to draw are combined by the balance heuristic (Eric
/// Veach 1997, "Robust Monte Carlo Methods for Light Transport Simulation", section 9.2). With it no estimate has an
/// infinite variance, though the lamp is a point. Russian roulette ends paths without bias.
///
/// Endless uniform fog of albedo 1 never lets a path end. There, one that has gone far from the lamp comes back to a
/// sphere around it as by diffusion, of which the distance to the lamp is a martingale for these walks too: exactly in
/// isotropic fog, and within the square of the transport mean free path over the sphere's radius, below 1/100, else.
///
/// atmosphere  its top is not looked at
/// throws      std::invalid_argument naming field, value and rule
ScatteredLight walk_scattering(const PlacedLight& light, const Atmosphere& atmosphere, const EyeRay& ray,
                               const ScatteringWalk& walk = {});

}  // namespace litfog::measure
