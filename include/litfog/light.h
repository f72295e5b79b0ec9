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
  double density_scale = 1;  ///< finite, >= 0: its class sees this fraction of the fog's density; 0: no fog
  /// Radius R of the lamp's luminous disc in metres, finite, >= 0; 0: none is known. Only photometric() reads it. Above
  /// 0 it needs quadratic > 0 and at most constant / R^2, and a colour that stays finite over quadratic R^2.
  double source_radius = 0;
  Flash flash = {};  ///< when the lamp is lit; only what takes a time reads it, all else the light as if steady
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

/// Illuminance of colour 1 at attenuation 1 in lux: at an exposure of 0 EV a white wall that faces it is white.
inline constexpr double kWhiteLux = 20;

/// Largest relative error of photometric's members, of those that are neither 0 nor beyond 1e-100..1e100.
inline constexpr double kPhotometricMaxError = 1e-15;

/// The light as it is near the lamp, where the clamp of the range attenuation would cut it off. With R its source
/// radius and C, L, Q its attenuation it lights a surface that faces it by
///   E(r) = color / (Q R^2 + L r + Q r^2),
/// which for L = 0 is the illuminance I / (r^2 + R^2) of a Lambertian disc on its axis, for I = color / Q. Far away it
/// is the light given. It is a light like any other, whose attenuation is 1 at the lamp and is clamped nowhere:
///   color' = color / (Q R^2), C' = 1, L' = L / (Q R^2), Q' = 1 / R^2, threshold' = threshold Q R^2.
///
/// returns    the light itself where its source radius is 0; else one without a source radius, dark where the light
///            given is below its threshold everywhere
/// max error  kPhotometricMaxError                                                                   (light_test.cpp)
/// throws     std::invalid_argument naming field, value and rule
Light photometric(const Light& light);

/// The light's far intensity on its axis in candela, a component a colour: kWhiteLux color / Q. Infinite for Q = 0.
///
/// throws  std::invalid_argument naming field, value and rule
glm::dvec3 candela(const Light& light);

/// What is wrong with a placed light or its light, or nothing. The value of a wrong direction is its length.
std::optional<ValueError> find_error(const PlacedLight& light);

}  // namespace litfog
