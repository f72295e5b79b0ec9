// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
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

/// Opaque surfaces that end rays, hide lamps and reflect light. They are Lambertian on both sides.
class Surroundings {
 public:
  struct Hit {
    double distance;    ///< metres along the ray
    glm::dvec3 normal;  ///< unit, on the ray's side
    double albedo;      ///< [0, 1]
  };

  virtual ~Surroundings() = default;
  /// The first surface on a ray.
  ///
  /// direction  unit
  virtual std::optional<Hit> nearest(const glm::dvec3& origin, const glm::dvec3& direction) const = 0;
  /// Whether a surface is between a lamp and a position in the fog, or on a surface.
  virtual bool is_hidden(const glm::dvec3& lamp, const glm::dvec3& position, bool is_on_surface) const = 0;
};

struct ScatteringWalk {
  std::uint64_t paths = 1 << 16;  ///< rounded up to a multiple of kScatteringBatches
  std::uint64_t seed = 1;
  std::size_t threads = 0;  ///< 0: all cores; does not change the result
  /// Where the caller has ended the ray. A reflection counts as a scattering. Null: none.
  const Surroundings* surroundings = nullptr;
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

/// The paths of walk_scattering() one by one, for pictures.
class ScatteringPaths {
 public:
  /// surroundings  must outlive this object; null: none
  /// throws        std::invalid_argument naming field, value and rule
  ScatteringPaths(const PlacedLight& light, const Atmosphere& atmosphere, const glm::dvec3& eye,
                  const Surroundings* surroundings = nullptr);
  ~ScatteringPaths();
  ScatteringPaths(ScatteringPaths&&) noexcept;
  ScatteringPaths& operator=(ScatteringPaths&&) noexcept;

  /// An unbiased sample of M in the unit of airlight(), along a ray from the eye that has no find_error() and ends
  /// where the caller sees a surface. Each path of a seed is another sample.
  double scattered(const EyeRay& ray, std::uint64_t seed, std::uint64_t path) const;
  /// An unbiased sample of the radiance of a white surface lit by light that was scattered or reflected elsewhere, in
  /// the same unit.
  ///
  /// normal  unit
  double reflected(const glm::dvec3& position, const glm::dvec3& normal, std::uint64_t seed, std::uint64_t path) const;

 private:
  friend ScatteredLight walk_scattering(const PlacedLight&, const Atmosphere&, const EyeRay&, const ScatteringWalk&);
  class Walk;
  std::unique_ptr<const Walk> walk_;
};

}  // namespace litfog::measure
