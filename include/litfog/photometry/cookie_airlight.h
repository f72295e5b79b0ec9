// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/mat3x3.hpp>

#include "litfog/airlight.h"
#include "litfog/photometry/cookie.h"
#include "litfog/scattered_beam.h"

namespace litfog {

/// Largest error of airlight() with a cookie as smooth as a beam of cos^4. Finer detail may fall between the nodes.
inline constexpr double kCookieAirlightMaxError = 1 / 255.;

/// Airlight (airlight.h) of a light whose angular shape is a cookie instead of its cone.
///
/// cookie             must pass find_error(); not checked here
/// cookie_from_world  a rotation: the light's axis becomes -z, its up +y
/// max error          kCookieAirlightMaxError                                              (cookie_airlight_test.cpp)
/// throws             std::invalid_argument naming field, value and rule
double airlight(const PlacedLight& light, const Cookie& cookie, const glm::dmat3& cookie_from_world,
                const Atmosphere& atmosphere, const EyeRay& ray, LampLeg lamp_leg = LampLeg::fogged);

/// Airlight with a cookie by adaptive quadrature, split wherever the ray passes from one texel to another.
///
/// max error  kReferenceAirlightMaxError, or 1e-16 of the airlight without the cookie      (cookie_airlight_test.cpp)
/// throws     std::invalid_argument naming field, value and rule
double reference_airlight(const PlacedLight& light, const Cookie& cookie, const glm::dmat3& cookie_from_world,
                          const Atmosphere& atmosphere, const EyeRay& ray, LampLeg lamp_leg = LampLeg::fogged);

/// The same for reference pictures, in double, of lights and fogs whose coefficients and densities are 0 or in [1e-20,
/// 1e20].
///
/// max error  kPictureAirlightMaxError                                                     (cookie_airlight_test.cpp)
/// throws     std::invalid_argument naming field, value and rule
double picture_airlight(const PlacedLight& light, const Cookie& cookie, const glm::dmat3& cookie_from_world,
                        const Atmosphere& atmosphere, const EyeRay& ray, LampLeg lamp_leg = LampLeg::fogged);

/// Largest relative error of beam_moments() for smooth beams that span six texels and more: of the flux, and of its
/// mean cosine's difference from 1.
inline constexpr double kCookieMomentMaxError = 2e-3;

/// Moments of a cookie about the light's axis (scattered_beam.h), by a sum over its texels.
///
/// max error  kCookieMomentMaxError                                                        (cookie_airlight_test.cpp)
BeamMoments beam_moments(const Cookie& cookie);

}  // namespace litfog
