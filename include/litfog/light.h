// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <string>

#include "litfog/attenuation.h"
#include "litfog/cone.h"
#include "litfog/value_error.h"

namespace litfog {

/// A light as a light file holds it, without position and direction.
struct Light {
  std::string name;
  glm::dvec3 color{1.0};  ///< linear RGB, finite, >= 0; 1 is the display's white
  Attenuation attenuation;
  double threshold = kDefaultThreshold;  ///< (0, 1): attenuation at which the light ends
  Cone cone;
  double density_scale = 1;  ///< finite, >= 0: its class sees this fraction of the fog's density; 0: no fog
};

/// Largest coordinate of a light's position in metres, 2^24: beyond it the floats of the shaders are 2 m apart.
inline constexpr double kMaxPosition = 16'777'216;

/// How far from 1 the length of a light's direction may be: ten times the rounding of normalising in float.
inline constexpr double kDirectionTolerance = 1e-6;

/// A light in a scene. World space, metres.
struct PlacedLight {
  Light light;
  glm::dvec3 position{0.0};              ///< each coordinate at most kMaxPosition in magnitude
  glm::dvec3 direction{0.0, 0.0, -1.0};  ///< axis of the cone; its length is 1 within kDirectionTolerance
  bool carried = false;                  ///< by the eye's vehicle; only carried lights light the fog by Hales's term
};

/// What is wrong with a light, or nothing.
std::optional<ValueError> find_error(const Light& light);

/// What is wrong with a placed light or its light, or nothing. The value of a wrong direction is its length.
std::optional<ValueError> find_error(const PlacedLight& light);

}  // namespace litfog
