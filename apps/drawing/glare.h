// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/picture.h"

namespace litfog::drawing {

/// Whether a display shows a lamp as an eye sees it, whose optics spread its light: of two lamps the brighter is the
/// larger.
enum class Glare { none, eye };

/// How a normal eye in bright light spreads a point's light, in 1/sr: the photopic function of Spencer, Shirley,
/// Zimmerman and Greenberg 1995, "Physically-Based Glare Effects for Digital Images". It has no colour. Its integral
/// over the hemisphere is 1 within 0.05 %.
///
/// angle  from the point, radians, >= 0
double eye_spread(double angle);

/// A picture as the eye's optics spread its light. What would fall outside the picture is lost, and nothing comes in
/// from there. A channel of infinity or NaN stays and spreads nothing, one below 0 spreads nothing.
///
/// Pixels are flat: each is as wide as one at the picture's middle. So the glare of a lamp that the camera sees at an
/// angle a from there is off: up to cos(a)^-3 times too dark along the radius, up to 1 / cos(a) times too bright across
/// it. In the corners of a 16:9 picture of 57 degrees in height that is 3.4 and 1.5.
///
/// pixels_per_radian  at the picture's middle, > 0
render::Picture with_glare(const render::Picture& picture, double pixels_per_radian);

}  // namespace litfog::drawing
