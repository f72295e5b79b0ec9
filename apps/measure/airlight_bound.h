// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "litfog/airlight.h"
#include "measure/reference_light.h"

namespace litfog::measure {

/// A bound of a light's airlight along a ray, through fog that dims the lamp's leg too: cheap enough to find the few
/// lights of thousands that matter. Cookies count as if they let all light through.
///
/// The largest weight of the fog, -f'(s) f(r), times the integral of the attenuation over the ray bounds the airlight.
/// The integral is at most the attenuation at the point nearest to the lamp times the length within the extent; and
/// with D the attenuation's denominator and h the lamp's distance from the ray's line, at most pi / sqrt(Q D(h)),
/// because D >= D(h) + Q x^2 at the distance x from the closest approach. The attenuation at the nearest point alone is
/// a bound, too: the fog's -f' adds up to at most 1. All of them are multiplied with the cone at the smallest angle
/// from its axis, and with the largest value of the phase function.
///
/// returns  >= airlight, >= 0; may be infinite only where the attenuation is
double airlight_bound(const ReferenceLight& light, const EyeRay& ray, const Atmosphere& atmosphere);

}  // namespace litfog::measure
