// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include "litfog/fog.h"
#include "render/light/scene_lights.h"
#include "render/plan/lighting_path.h"
#include "scene/mesh.h"

namespace litfog::render {

/// Fractions of one step of the display, 1/255, that a frame may leave out of a pixel. A sample that shows a surface is
/// darker by the lights left out. A sample of a surface or sky left out shows what stands behind. Both the one left out
/// and the one shown may be brighter than the fog by kHiddenShare, so the sample errs by up to that much either way.
/// Points and airlight of lamps left out are missing as well. So all errors of a pixel lie in a range of
/// kSurfaceLightShare + 2 kHiddenShare + kPointShare + kBehindShare + kAirlightShare + kFarShare = 1 step, and from one
/// frame to the next they change by no more.
inline constexpr double kSurfaceLightShare = 1 / 4.;  ///< all lights left out of a surface
inline constexpr double kHiddenShare = 1 / 8.;        ///< a surface or the sky
inline constexpr double kPointShare = 1 / 8.;         ///< points of all lamps
inline constexpr double kBehindShare = 1 / 8.;        ///< airlight from behind surfaces that are left out
inline constexpr double kAirlightShare = 1 / 8.;      ///< airlight of all lamps, in pixels beyond their reach
inline constexpr double kFarShare = 1 / 8.;           ///< airlight of all lamps beyond their extents

/// The least light that makes a step of 1/255 on a display, linear, before exposure. sRGB is steepest at black, and no
/// ToneCurve makes it steeper.
///
/// exposure  EV, [-kMaxExposure, kMaxExposure]
double visible_step(double exposure);

/// The range beyond which fog hides a brightness: f(r) * brightness <= budget. Metres; 0 if always hidden, infinity if
/// never.
double hidden_range(const Fog& fog, double brightness, double budget);

/// Upper bound of a light's irradiance at any point of a box, divided by its colour.
///
/// Proof. Cones and cookies are at most 1. All range laws, and the transmittance from the light, fall with the range,
/// so they are largest at the point of the box nearest to the light. A look-up in a map interpolates texels, the
/// largest of which is the value at the light.
///
/// position, extent  the light's, metres
double largest_irradiance(const Light& light, const glm::dvec3& position, double extent, const Fog& fog,
                          FogLighting fog_lighting, const LightingPath& path, const scene::Bounds& box);

/// Whether a light's cone can meet a ray from the eye through a box, anywhere beyond a range.
///
/// Proof. Seen from the eye, the ball around the box lies within an angle of asin(radius / distance) of its centre. The
/// directions from the eye and from the light to a point of such a ray beyond the range differ by at most
/// asin(delta / range), where delta is the distance from the eye to the light. So the point's angle from the light's
/// axis is at least the angle of the ball's centre minus both.
///
/// half_angle  the cone's, radians
/// range       metres from the eye
bool can_light_from(const PlacedLight& light, double half_angle, const glm::dvec3& eye, const scene::Bounds& box,
                    double range);

}  // namespace litfog::render
