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

/// metres: height of the haze over which light from outside comes down where no top is stated: the scale height of
/// aerosols, so that the haze has as much depth as if it thinned out upwards from height 0 (Tomoyuki Nishita et al.
/// 1993, "Display of the Earth Taking into Account Atmospheric Scattering")
inline constexpr double kHazeHeight = 1200;

/// All that the air is. Its density at a height is the fog's plus the profile's.
struct Atmosphere {
  Fog fog = {};
  Phase phase = {};
  double albedo = 1;  ///< [0, 1]: the fraction of the light taken by the fog that it scatters; all orders need 1
  /// metres: height at which rays to the sky leave the fog, if no layer is there or higher: top_above(). It is also
  /// where light from outside enters: light_top().
  double top = std::numeric_limits<double>::infinity();
  glm::dvec3 ambient_fog_color{0.0};  ///< linear RGB, finite, >= 0: all of the fog's light that is no airlight
  DensityProfile profile = {};        ///< layers, in exp fog only; light classes scale its density like the fog's

  friend bool operator==(const Atmosphere&, const Atmosphere&) = default;

  /// The same air with another fog.
  Atmosphere with(const Fog& other) const {
    Atmosphere air = *this;
    air.fog = other;
    return air;
  }

  /// The same air with its heights measured from another origin, but for kHazeHeight, which light_top() then has above
  /// that one. What is so moved beyond 16777216 m in magnitude no longer passes find_error().
  ///
  /// height  of that origin, metres
  Atmosphere seen_from(double height) const;

  /// Uniform fog of the mean density between two heights, in either order: the fog factor and opacity of a straight
  /// line from one to the other are those in it.
  ///
  /// height_a, height_b  metres, finite
  Fog fog_between(double height_a, double height_b) const {
    return {fog.mode, fog.density + mean_density(profile, height_a, height_b)};
  }
  /// Uniform fog of the density at a height, which may be infinite. FogUpdater takes that at the eye's height.
  Fog fog_at(double height) const { return {fog.mode, fog.density + profile_density_at(profile, height)}; }
  /// Uniform fog of the least and of the largest density at any height, for bounds.
  Fog thinnest_fog() const { return {fog.mode, fog.density + smallest_density(profile)}; }
  Fog thickest_fog() const { return {fog.mode, fog.density + largest_density(profile)}; }
  /// Uniform fog that hides no more than this air does between a point at a height and any point from one height to
  /// another: least_mean_density().
  Fog thinnest_fog_between(double height, double lowest, double highest) const {
    return profile.count == 0 ? fog : Fog{fog.mode, fog.density + least_mean_density(profile, height, lowest, highest)};
  }

  /// How far rays to the sky are above a height when they leave the fog, metres: at the top, or at the last knot where
  /// that is higher. Infinity: they do not leave it at a top; nor do they leave a profile that is not 0 above its
  /// knots.
  double top_above(double height) const;
  /// Height at which the light of the sun or the moon enters the fog, metres, finite where the top is not -infinity:
  /// the top, or kHazeHeight above height 0 where that is infinite, and at least the last knot's height. So haze on
  /// ground that lies above kHazeHeight takes nothing of that light, unless the top is stated. A profile that is not 0
  /// above its knots goes on for kHazeHeight above the last.
  double light_top() const;
};

/// What is wrong with an atmosphere, or nothing.
std::optional<ValueError> find_error(const Atmosphere& atmosphere);

}  // namespace litfog
