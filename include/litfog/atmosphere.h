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

/// All that the air is. Its density at a height is the fog's plus the profile's.
struct Atmosphere {
  Fog fog = {};
  Phase phase = {};
  double albedo = 1;  ///< [0, 1]: the fraction of the light taken by the fog that it scatters
  /// metres: height at which rays to the sky leave the fog; taken as infinity where there is a profile, whose rays
  /// leave the fog where its density is 0
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

  /// The same air with its heights measured from another origin. What is so moved beyond 16777216 m in magnitude no
  /// longer passes find_error().
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

  /// How far rays to the sky are above a height when they leave the fog, metres; infinity: they do not leave it at a
  /// top.
  double top_above(double height) const {
    return profile.count > 0 ? std::numeric_limits<double>::infinity() : top - height;
  }
};

/// What is wrong with an atmosphere, or nothing.
std::optional<ValueError> find_error(const Atmosphere& atmosphere);

}  // namespace litfog
