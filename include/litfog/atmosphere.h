// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec3.hpp>
#include <limits>
#include <optional>

#include "litfog/density_profile.h"
#include "litfog/fog.h"
#include "litfog/phase.h"
#include "litfog/value_error.h"

namespace litfog {

/// Height in metres at which light of the sun or the moon enters fog that has no top: the scale height of aerosols.
/// Haze then has the optical depth that it has if it thins out exponentially from height 0 (Tomoyuki Nishita et al.
/// 1993, "Display of the Earth Taking into Account Atmospheric Scattering").
inline constexpr double kHazeHeight = 1200;

/// Everything about the air. Its density at a height is the fog's plus the profile's.
struct Atmosphere {
  Fog fog = {};
  Phase phase = {};
  double albedo = 1;  ///< [0, 1]: scattering over extinction; all orders of scattering need 1
  /// metres: height at which rays to the sky leave the fog, unless a layer reaches higher: top_above(). Light of the
  /// sun or the moon also enters there: light_top().
  double top = std::numeric_limits<double>::infinity();
  glm::dvec3 ambient_fog_color{0.0};  ///< linear RGB, finite, >= 0: all of the fog's light that is not airlight
  DensityProfile profile = {};        ///< layers, in exp fog only; light classes scale its density like the fog's

  friend bool operator==(const Atmosphere&, const Atmosphere&) = default;

  /// The same air with another fog.
  Atmosphere with(const Fog& other) const {
    Atmosphere air = *this;
    air.fog = other;
    return air;
  }

  /// The same air with heights measured from another origin. kHazeHeight does not move: light_top() adds it above the
  /// new origin. Heights moved beyond 16777216 m in magnitude no longer pass find_error().
  ///
  /// height  the new origin's, metres
  Atmosphere seen_from(double height) const;

  /// Uniform fog with the mean density between two heights, in either order. A straight line between the heights has
  /// the same fog factor and opacity in it.
  ///
  /// height_a, height_b  metres, finite
  Fog fog_between(double height_a, double height_b) const {
    return {fog.mode, fog.density + mean_density(profile, height_a, height_b)};
  }
  /// Uniform fog with the density at a height, which may be infinite. FogUpdater takes the fog at the eye's height.
  Fog fog_at(double height) const { return {fog.mode, fog.density + profile_density_at(profile, height)}; }
  /// Uniform fogs with the least and the largest density at any height, for bounds.
  Fog thinnest_fog() const { return {fog.mode, fog.density + smallest_density(profile)}; }
  Fog thickest_fog() const { return {fog.mode, fog.density + largest_density(profile)}; }
  /// Uniform fog that hides no more than this air does, between a point at `height` and any point from `lowest` to
  /// `highest`: least_mean_density().
  Fog thinnest_fog_between(double height, double lowest, double highest) const {
    return profile.count == 0 ? fog : Fog{fog.mode, fog.density + least_mean_density(profile, height, lowest, highest)};
  }

  /// Height in metres above `height` at which rays to the sky leave the fog: at the top, or at the last knot if that is
  /// higher. Infinity if they never leave it: without a top, or in a profile that is not 0 above its knots.
  double top_above(double height) const;
  /// Height in metres at which the light of the sun or the moon enters the fog: the top, or kHazeHeight above height 0
  /// if that is infinite, and at least the last knot's height. Haze on ground above kHazeHeight dims none of that light
  /// unless the top is stated. A profile that is not 0 above its knots ends kHazeHeight above the last. Finite unless
  /// the top is -infinity.
  double light_top() const;
};

/// What is wrong with an atmosphere, or nothing.
std::optional<ValueError> find_error(const Atmosphere& atmosphere);

}  // namespace litfog
