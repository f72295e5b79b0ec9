// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "litfog/airlight.h"

namespace litfog::measure {

/// A Monte Carlo estimate.
struct Estimate {
  double value = 0;
  double error = 0;  ///< standard error
};

/// Light that the fog scatters into the eye, by order of scattering, in the unit of airlight(): a picture shows it
/// times the light's colour and airlight_unit().
struct ScatteredLight {
  Estimate first;   ///< once: the airlight
  Estimate second;  ///< twice
  Estimate higher;  ///< twice or more often: M, which airlight() lacks
};

/// A Lambertian ground, the horizontal plane at a height. Lamp and eye are above it.
struct Ground {
  double height = 0;  ///< metres
  double albedo = 0;  ///< [0, 1]
};

struct ScatteringWalk {
  std::uint64_t paths = 1 << 16;  ///< rounded up to a multiple of kScatteringBatches
  std::uint64_t seed = 1;
  std::size_t threads = 0;       ///< 0: all cores; does not change the result
  std::optional<Ground> ground;  ///< rays end there; a reflection counts as a scattering
};

/// Independent batches of paths. Their spread gives the standard error.
inline constexpr std::size_t kScatteringBatches = 64;

/// All orders of scattering of a light along a ray, by a random walk from the eye (Monte Carlo), in exp fog that also
/// dims the leg from the lamp. The reference for litfog's own orders. Takes seconds.
///
/// Each path begins on the eye's ray and goes on by the phase function and the law of free paths. At each vertex light
/// arrives over one more scattering on a leg. The leg's direction is drawn from the phase function, towards the lamp
/// or, for a spot, into the beam. The position on the leg is drawn by the angle at the lamp (Christopher Kulla and
/// Marcos Fajardo 2012, "Importance Sampling Techniques for Path Tracing in Participating Media", section 3.1),
/// weighted by the phase function. The balance heuristic combines all sampling techniques (Eric Veach 1997, "Robust
/// Monte Carlo Methods for Light Transport Simulation", section 9.2), so that no estimate has an infinite variance,
/// though the lamp is a point. Russian roulette ends paths without bias.
///
/// In endless uniform fog of albedo 1 no path ends. There a path far from the lamp returns to a sphere around it as by
/// diffusion: its probability, radius over distance, also holds for these walks, exactly in isotropic fog, else within
/// the square of the transport mean free path over the sphere's radius, below 1/100.
///
/// atmosphere  its top is ignored
/// throws      std::invalid_argument naming field, value and rule
ScatteredLight walk_scattering(const PlacedLight& light, const Atmosphere& atmosphere, const EyeRay& ray,
                               const ScatteringWalk& walk = {});

}  // namespace litfog::measure
