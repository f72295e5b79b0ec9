// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "litfog/airlight.h"
#include "litfog/atmosphere.h"
#include "litfog/light.h"

namespace litfog::window {

/// A light's airlight along a ray, accumulated from the eye on, as a fraction of the light's colour.
struct AirlightCurve {
  double end;                  ///< metres: > 0, finite
  std::vector<double> single;  ///< airlight() up to the distances end * i / (size - 1)
  std::vector<double> all;     ///< plus multiple_scattering(); empty in atmospheres without it
};

/// The curve up to the surface that a ray meets, or else to twice the distance at which it passes the light, at least
/// to the light's distance.
///
/// samples  >= 2
/// throws   std::invalid_argument naming field, value and rule
AirlightCurve make_airlight_curve(const PlacedLight& light, const Atmosphere& atmosphere, const EyeRay& ray,
                                  int samples);

}  // namespace litfog::window
