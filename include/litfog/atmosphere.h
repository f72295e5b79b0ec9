// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec3.hpp>
#include <limits>
#include <optional>

#include "litfog/fog.h"
#include "litfog/phase.h"
#include "litfog/value_error.h"

namespace litfog {

/// All that the air is.
struct Atmosphere {
  Fog fog = {};
  Phase phase = {};
  double albedo = 1;  ///< [0, 1]: the fraction of the light taken by the fog that it scatters
  double top = std::numeric_limits<double>::infinity();  ///< metres: height at which rays to the sky leave the fog
  glm::dvec3 ambient_fog_color{0.0};                     ///< linear RGB, finite, >= 0

  friend bool operator==(const Atmosphere&, const Atmosphere&) = default;

  /// The same air with another fog.
  Atmosphere with(const Fog& other) const {
    Atmosphere air = *this;
    air.fog = other;
    return air;
  }
};

/// What is wrong with an atmosphere, or nothing.
std::optional<ValueError> find_error(const Atmosphere& atmosphere);

}  // namespace litfog
