// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <string>

#include "litfog/attenuation.h"
#include "litfog/cone.h"
#include "litfog/flash.h"
#include "litfog/value_error.h"

namespace litfog {

/// A light as a light file holds it, without position and direction.
struct Light {
  std::string name;
  glm::dvec3 color{1.0};  ///< linear RGB, finite, >= 0; 1 is the display's white
  Attenuation attenuation;
  double threshold = kDefaultThreshold;  ///< (0, 1): attenuation at which the light ends
  Cone cone;
  double density_scale = 1;  ///< finite, >= 0: factor on the fog's density for this light; 0: no fog
  /// Radius R of the lamp's luminous disc in metres, finite, >= 0; 0: unknown. Only photometric() reads it. If R > 0,
  /// quadratic must be in (0, constant / R^2], and color / (quadratic R^2) finite.
  double source_radius = 0;
  Flash flash = {};  ///< when the lamp is lit; calls that take no time treat the lamp as steady
};

/// Largest coordinate of a light's position in metres, 2^24: beyond it the floats of the shaders are 2 m apart.
inline constexpr double kMaxPosition = 16'777'216;

/// How far the length of a direction may differ from 1: ten times the rounding of normalising in float.
inline constexpr double kDirectionTolerance = 1e-6;

/// A light in a scene. World space, metres.
struct PlacedLight {
  Light light;
  glm::dvec3 position{0.0};              ///< each coordinate at most kMaxPosition in magnitude
  glm::dvec3 direction{0.0, 0.0, -1.0};  ///< axis of the cone; its length is 1 within kDirectionTolerance
  bool carried = false;                  ///< by the eye's vehicle; Hales's term is for carried lights only
};

/// What is wrong with a light, or nothing.
std::optional<ValueError> find_error(const Light& light);

/// Illuminance in lux of colour 1 at attenuation 1: at an exposure of 0 EV it makes a white wall white.
inline constexpr double kWhiteLux = 20;

/// Largest relative error of photometric's members that are 0 or within 1e-100..1e100.
inline constexpr double kPhotometricMaxError = 1e-15;

/// The light without the clamp of its range attenuation, as bright near the lamp as a disc. With R its source radius
/// and C, L, Q its attenuation, the illuminance of a surface that faces it is
///   E(r) = color / (Q R^2 + L r + Q r^2).
/// For L = 0 that is the illuminance I / (r^2 + R^2) of a Lambertian disc on its axis, with I = color / Q. Far away it
/// equals the given light. It is an ordinary light, whose attenuation is 1 at the lamp and needs no clamp:
///   color' = color / (Q R^2), C' = 1, L' = L / (Q R^2), Q' = 1 / R^2, threshold' = threshold Q R^2.
///
/// returns    the light itself if its source radius is 0; otherwise a light without a source radius, dark if the given
///            light is below its threshold everywhere
/// max error  kPhotometricMaxError                                                                   (light_test.cpp)
/// throws     std::invalid_argument naming field, value and rule
Light photometric(const Light& light);

/// The light's far intensity on its axis in candela, for each colour component: kWhiteLux color / Q. Infinite if Q = 0.
///
/// throws  std::invalid_argument naming field, value and rule
glm::dvec3 candela(const Light& light);

/// What is wrong with a placed light or its light, or nothing. The value of a wrong direction is its length.
std::optional<ValueError> find_error(const PlacedLight& light);

}  // namespace litfog
