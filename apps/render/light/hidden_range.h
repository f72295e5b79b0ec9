// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include "litfog/fog.h"
#include "render/light/scene_lights.h"
#include "render/plan/lighting_path.h"
#include "scene/mesh.h"

namespace litfog::render {

/// Shares of one step of the display, 1/255, that a frame may leave out of a pixel. A sample shows a surface, darker by
/// the lights left out of it, or what stands behind a surface or sky that is left out; each of the two may be brighter
/// than the fog by a share, so that the sample is darker or brighter by up to two. Over either come the lamps' points,
/// of which some are left out, and their airlight. So all errors of a pixel lie in a range of
/// kSurfaceLightShare + 2 kHiddenShare + kPointShare + kBehindShare + kAirlightShare + kFarShare = 1 step, and from one
/// frame to the next they change by no more.
inline constexpr double kSurfaceLightShare = 1 / 4.;  ///< all lights left out of a surface
inline constexpr double kHiddenShare = 1 / 8.;        ///< a surface, or the sky
inline constexpr double kPointShare = 1 / 8.;         ///< the points of all lamps
inline constexpr double kBehindShare = 1 / 8.;        ///< airlight from behind surfaces that are left out
inline constexpr double kAirlightShare = 1 / 8.;      ///< airlight of all lamps that pixels beyond their reach lack
inline constexpr double kFarShare = 1 / 8.;           ///< airlight of all lamps beyond their extents

/// The least light that makes a step of 1/255 on a display, linear, before exposure. sRGB is steepest where it is
/// darkest, with this slope, and no tone curve (ToneCurve) makes it steeper.
///
/// exposure  EV, [-kMaxExposure, kMaxExposure]
double visible_step(double exposure);

/// The range beyond which fog leaves less than a budget of a brightness: f(r) * brightness <= budget. Metres, 0 where
/// that is so everywhere, infinity where it is so nowhere.
double hidden_range(const Fog& fog, double brightness, double budget);

/// What a light can give to a point of a box, over its colour, before the surface reflects it.
///
/// Proof. Cones and cookies are at most 1. All range laws and the fog on the light's leg fall with the range, so that
/// they are largest at the point of the box nearest to the light. What is looked up in a map lies between texels, of
/// which the largest is the value at the light.
///
/// position, extent  of the light, metres
double largest_irradiance(const Light& light, const glm::dvec3& position, double extent, const Fog& fog,
                          FogLighting fog_lighting, const LightingPath& path, const scene::Bounds& box);

/// Whether a light's cone can meet a ray from the eye through a box, anywhere from a range on.
///
/// Proof. From the eye the box lies in the ball around it, within the angle of asin(radius / distance) of the ball's
/// middle. A point of such a ray at least that range from the eye, seen from the light instead, is turned by at most
/// asin(delta / range), where delta is the distance from the eye to the light. So its angle from the light's axis is at
/// least that of the ball's middle minus both.
///
/// half_angle  of the cone, radians
/// range       metres from the eye
bool can_light_from(const PlacedLight& light, double half_angle, const glm::dvec3& eye, const scene::Bounds& box,
                    double range);

}  // namespace litfog::render
