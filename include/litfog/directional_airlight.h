// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "litfog/airlight.h"
#include "litfog/atmosphere.h"

namespace litfog {

/// Fraction of a directional light, such as the sun or the moon, that reaches a height through the fog: e^-depth along
/// the light's slanted path from Atmosphere::light_top(). It lights surfaces. It tends to 1 as haze thins out, except
/// for light at or below the horizon, which any haze keeps out because fog is level.
///
/// atmosphere  exp fog (in exp2 fog the depths of two legs do not add up). If the top is infinite, the light enters at
///             kHazeHeight above height 0, wherever the ground is.
/// to_light    unit within kDirectionTolerance
/// height      metres, at most kMaxPosition in magnitude
/// returns     [0, 1]
/// throws      std::invalid_argument naming field, value and rule
double directional_fog_factor(const Atmosphere& atmosphere, const glm::dvec3& to_light, double height);

/// Largest relative error of directional_airlight. A ray that crosses a jump of density and rises by less than 1e-5 of
/// its height has a larger one, since its heights are rounded.
inline constexpr double kDirectionalAirlightMaxError = 1e-11;

/// Airlight of a directional light along rays: the fraction that the fog scatters into the eye,
///   A = integral over s in [0, D] of  d(s) e^(-depth from the eye - depth to the light) phase(theta)  ds,
/// in closed form, derived in litfog/shaders/directional_airlight.glsl. Where a white surface that faces the light
/// outside the fog shows colour, the fog shows airlight_unit() * colour * A. This is single scattering: the ambient fog
/// colour stands for light that is scattered more than once, and for other light. Spans of different lengths are a
/// caller's bug and assert.
///
/// atmosphere  exp fog, as for directional_fog_factor()
/// to_light    unit within kDirectionTolerance
/// rays        as for a lamp; rays to the sky must end at Atmosphere::light_top()
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
