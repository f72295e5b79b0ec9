// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/picture.h"

namespace litfog::drawing {

/// Whether a display shows a lamp with the glare of an eye, whose optics spread its light. A brighter lamp then looks
/// larger.
enum class Glare { none, eye };

/// How a normal eye in bright light spreads a point's light, in 1/sr: the photopic function of Spencer, Shirley,
/// Zimmerman and Greenberg 1995, "Physically-Based Glare Effects for Digital Images". It has no colour. Its integral
/// over the hemisphere is 1 within 0.05 %.
///
/// angle  from the direction to the point, radians, >= 0
double eye_spread(double angle);

/// Spreads a picture's light by the eye's optics. Light that leaves the picture is lost, and none enters. Infinite and
/// NaN channels stay and spread nothing; negative channels spread nothing.
///
/// Each pixel counts as wide as one at the picture's centre. So the glare of a lamp at an angle a from the centre is
/// wrong: up to cos(a)^-3 times too dark along the radius, up to 1 / cos(a) times too bright across it. In the corners
/// of a 16:9 picture of 57 degrees in height that is 3.4 and 1.5.
///
/// pixels_per_radian  at the picture's centre, > 0
render::Picture with_glare(const render::Picture& picture, double pixels_per_radian);

}  // namespace litfog::drawing
