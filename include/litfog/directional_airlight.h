// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "litfog/airlight.h"
#include "litfog/atmosphere.h"

namespace litfog {

/// Fraction of a directional light, such as the sun or the moon, that passes through the fog down to a height, e^-depth
/// along the light's own slant from Atmosphere::light_top(). Surfaces are lit by it. It is continuous where haze
/// vanishes; only light at the horizon or below it is kept out by any, because fog is level.
///
/// atmosphere  exp fog (in exp2 fog depths do not add up along two legs). Of an infinite top, light comes down from
///             kHazeHeight above height 0, wherever the ground is.
/// to_light    unit within kDirectionTolerance
/// height      metres, at most kMaxPosition in magnitude
/// returns     [0, 1]
/// throws      std::invalid_argument naming field, value and rule
double directional_fog_factor(const Atmosphere& atmosphere, const glm::dvec3& to_light, double height);

/// Largest relative error of directional_airlight.
inline constexpr double kDirectionalAirlightMaxError = 1e-11;

/// Airlight of a directional light along rays: the fraction that the fog scatters into the eye,
///   A = integral over s in [0, D] of  d(s) e^(-depth from the eye - depth to the light) phase(theta)  ds,
/// in closed form, derived in litfog/shaders/directional_airlight.glsl. A white surface that faces the light outside
/// the fog shows colour, the fog airlight_unit() * colour * A. It is single scattering: the ambient fog colour stands
/// for the light that is scattered more often, and for other light. Columns of different lengths are a bug of the
/// caller and assert.
///
/// atmosphere  exp fog, as directional_fog_factor() takes it
/// to_light    unit within kDirectionTolerance
/// rays        as for a lamp; to the sky they end at Atmosphere::light_top(), above which fog is meant for other rays
/// airlights   [0, largest_phase()]
/// max error   kDirectionalAirlightMaxError                                             (directional_airlight_test.cpp)
/// throws      std::invalid_argument naming field, value and rule, before any result is written
void directional_airlight(const Atmosphere& atmosphere, const glm::dvec3& to_light, std::span<const EyeRay> rays,
                          std::span<double> airlights);

inline double directional_airlight(const Atmosphere& atmosphere, const glm::dvec3& to_light, const EyeRay& ray) {
  double airlight = 0;
  directional_airlight(atmosphere, to_light, {&ray, 1}, {&airlight, 1});
  return airlight;
}

}  // namespace litfog
