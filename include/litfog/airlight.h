// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <limits>
#include <optional>
#include <span>

#include "litfog/atmosphere.h"
#include "litfog/attenuation.h"
#include "litfog/light.h"
#include "litfog/value_error.h"

namespace litfog {

/// The lamp's leg: the light's path through the fog from the lamp to where it is scattered.
enum class LampLeg {
  clear,  ///< k = 0: no loss on this leg, as in Hales's model, which has the eye's leg only
  fogged  ///< k = 1: light is dimmed by the fog factor f(r) on this leg (single scattering)
};

/// A ray from the eye to what it sees. World space, metres.
struct EyeRay {
  glm::dvec3 origin{0.0};                                   ///< each coordinate at most kMaxPosition in magnitude
  glm::dvec3 direction{0.0, 0.0, -1.0};                     ///< its length is 1 within kDirectionTolerance
  double length = std::numeric_limits<double>::infinity();  ///< D, >= 0: to the surface or to the end of the fog
};

/// What is wrong with a ray, or nothing.
std::optional<ValueError> find_error(const EyeRay& ray);

/// Largest errors of airlight(), from clear air to a visibility of 5 cm, for cones of at least 0.1 degree,
/// |g| <= 0.99 and Phase::droplets().
///
/// | light              | fog       | bound                                                      | test           |
/// |--------------------|-----------|------------------------------------------------------------|----------------|
/// | any                | exp, exp2 | kAirlightMaxError in every ray                             | airlight_climb |
/// | point              | exp       | kShapedAirlightMaxError instead, unless isotropic          | airlight_climb |
/// | cone               | exp       | kShapedConeAirlightMaxError instead, unless isotropic      | airlight_climb |
/// | point              | layers    | kShapedLayeredAirlightMaxError, unless isotropic           | airlight_climb |
/// | any other          | layers    | kLayeredAirlightMaxError in every ray                      | airlight_climb |
/// | point              | exp, exp2 | kAirlightTypicalError in 99 of 100 rays                    | airlight_test  |
/// | cone               | exp, exp2 | kAirlightTypicalError in 99 of 100 rays above kDimAirlight | airlight_test  |
/// | photometric        | exp, exp2 | kPhotometricAirlightMaxError in every ray                  | airlight_test  |
///
/// kAirlightTypicalError holds in layers, too, and kPhotometricAirlightMaxError where they are of droplets or
/// isotropic, the lamp is in or beside one and the lamp's leg is fogged. The first five are fractions of the lamp's
/// colour, or of the airlight where that is above 1. The other bounds are fractions of the airlight. Their rays are
/// random, or pass a light at any one angle (0.1 to 179 degrees) and distance from the eye (0.02 to 4 fog scales, 1 /
/// density), where rays of a point whose airlight is below 1e-12 do not count. A photometric light has a source radius
/// of 0.02 to 2 m, is up to 1e5 times as bright as white, and counts where its colour times its airlight is above
/// kDimPhotometricAirlight, a quarter of an 8-bit step. A cone's airlight below kDimAirlight is rounding at the cone's
/// outermost edge, which no 8-bit display shows unless the lamp is over a million times as bright as white.
inline constexpr double kAirlightMaxError = 1 / 255.;
inline constexpr double kShapedAirlightMaxError = 6 / 255.;
inline constexpr double kShapedConeAirlightMaxError = 3 / 255.;
inline constexpr double kLayeredAirlightMaxError = 3 / 255.;
inline constexpr double kShapedLayeredAirlightMaxError = 0.1;
inline constexpr double kAirlightTypicalError = 0.01;
inline constexpr double kPhotometricAirlightMaxError = 0.035;
inline constexpr double kDimPhotometricAirlight = 1e-3;
inline constexpr double kDimAirlight = 1e-10;

/// What a picture shows of a colour times its airlight, in fog of albedo 1 and in an atmosphere. A white surface that a
/// lamp lights by E lux at right angles shows E / pi to the eye, and isotropic fog that scatters all it takes E / (4
/// pi).
inline constexpr double kAirlightUnit = 0.25;
inline double airlight_unit(const Atmosphere& atmosphere) { return kAirlightUnit * atmosphere.albedo; }

/// Airlight of a light along a ray: the fraction that the fog scatters into the eye, a factor of the light's colour,
///   A = integral over s in [0, D] of  -f'(s) a(r) cone(u) f(r)^k phase(theta)  ds
/// where s is the distance from the eye, r and u are range and angle from the light, theta is the angle of scattering,
/// and a(r) = 0 beyond the light's extent. The phase function is divided by its isotropic value.
///
/// light      its extent is that of its threshold; its class sees the fog at its density scale
/// atmosphere of the scene; rays end at its top, if they do, by their lengths
/// returns    [0, 1] in isotropic fog; up to largest_phase() else
/// max error  kAirlightMaxError or kShapedAirlightMaxError, mostly kAirlightTypicalError            (airlight_test.cpp)
/// throws     std::invalid_argument naming field, value and rule
double airlight(const PlacedLight& light, const Atmosphere& atmosphere, const EyeRay& ray,
                LampLeg lamp_leg = LampLeg::fogged);

/// Airlight along many rays. Columns of different lengths are a bug of the caller and assert.
///
/// throws     std::invalid_argument naming field, value and rule, before any result is written
void airlight(const PlacedLight& light, const Atmosphere& atmosphere, std::span<const EyeRay> rays, LampLeg lamp_leg,
              std::span<double> airlights);

/// Largest error of reference_airlight for |g| up to 0.99: this fraction of the airlight or, for a spot, 1e-19 of its
/// airlight without the cone, whichever is larger. For a ray that comes no nearer to a light than 1 - x of its extent,
/// it is kGrazingReferenceAirlightError / x of the airlight where that is more (x below 1e-8).
inline constexpr double kReferenceAirlightMaxError = 1e-10;
inline constexpr double kGrazingReferenceAirlightError = 1e-18;

/// Airlight by adaptive quadrature, cut wherever the integrand is not smooth. For tests and comparisons: it takes some
/// 50 to 150 times as long (`litfog-bench airlight`) and allocates.
///
/// max error  kReferenceAirlightMaxError                                                            (airlight_test.cpp)
/// throws     std::invalid_argument naming field, value and rule
double reference_airlight(const PlacedLight& light, const Atmosphere& atmosphere, const EyeRay& ray,
                          LampLeg lamp_leg = LampLeg::fogged);

/// Upper bound of a light's airlight along any ray from the eye, however long, within an angle of an axis. For skipping
/// a light for a tile of the picture, or for all of it.
///
/// Proof. The phase function is at most p = largest_phase() and the cone 1. No point of the rays lies nearer to
/// the light than h, the distance from the light to the cone of rays: its range from the eye times the sine of the
/// angle by which it lies outside the cone, all of its range where that is over 90 degrees, 0 inside. a falls with the
/// range, so that it is at most a(h), and 0 where h is not below the extent E. The lit stretch of a ray is a chord of
/// the sphere of radius E, at most c = 2 sqrt(E^2 - h^2) long, and begins at s0 or later, s0 = max(0, R - E) from the
/// eye, R being the light's range. Hence
///   A <= p a(h) f(s0) (1 - f(c))                 in exp fog, f(s0) in the thinnest of it and f(c) in the thickest;
///   A <= p a(h) min(f(s0), c d sqrt(2 / e))      in exp2 fog, where -f' is at most d sqrt(2 / e).
/// With the lamp's leg fogged the integrand has the factor f(r) as well, and f(r) <= f(h) in the thinnest fog.
/// Rounding: h is lowered and the rest raised by 1e-12 of itself.
/// The bounds of litfog/shaders/airlight_bound.glsl would be looser: they know neither f(s0) nor that fog ends.
///
/// eye         each coordinate at most kMaxPosition in magnitude
/// direction   the axis of the rays; its length is 1 within kDirectionTolerance
/// half_angle  radians, [0, pi]; pi is all rays
/// returns     never below the airlight, exact or by reference_airlight                             (airlight_test.cpp)
/// throws      std::invalid_argument naming field, value and rule
double bound_airlight(const PlacedLight& light, const Atmosphere& atmosphere, const glm::dvec3& eye,
                      const glm::dvec3& direction, double half_angle, LampLeg lamp_leg = LampLeg::fogged);

/// The range beyond which a light is visible neither on surfaces nor in fog, because a(r) f(r)^k stays below a budget.
/// The lit part of the scene lies in the sphere of this radius around the light.
///
/// Proof. a and f fall, and so does their product, which is below the budget at all ranges beyond one where it is
/// below. The range returned is the extent, or the upper end of a bisection, where the product is below the budget.
///
/// fog      in layered air Atmosphere::thinnest_fog()
/// budget   (0, 1): a fraction of the largest component of the light's colour
/// returns  metres, [0, extent], at most 1e-9 of itself too long (airlight_test.cpp); infinite for constant attenuation
///          above the budget in clear air or with the lamp's leg clear
/// throws   std::invalid_argument naming field, value and rule
double light_reach(const Light& light, const Fog& fog, double budget, LampLeg lamp_leg = LampLeg::fogged);

/// The budget of light_reach() at which all that lights add beyond their reaches stays below a step of a picture.
///
/// Proof. A light of budget b and brightness c adds less than b c to a surface beyond its reach, and less than p b c to
/// the fog before it, where p is airlight_unit() times largest_phase(), because a f < b there, and -f' has an integral
/// of at most 1. All lights together add less than their number times (1 + p) b c.
///
/// step        linear light, finite, > 0; of surfaces that reflect at most what they receive, diffuse and specular
/// lights      of the scene
/// brightness  the largest component of the light's colour, finite, >= 0
/// returns     (0, 0.5]
/// throws      std::invalid_argument naming field, value and rule
double reach_budget(double step, std::size_t lights, double brightness, const Atmosphere& atmosphere);

/// Largest error of axial_airlight in ulp.
inline constexpr double kAxialAirlightMaxUlp = 3;

/// Airlight of a light along its own axis, with the eye at the light and the lamp's leg clear, out to the extent,
///   A = integral of a(r) d(1 - f(r)) over [0, extent].
/// The fog colour intensity (solve.h) is the largest rectangle under a over 1 - f, so that A is never less.
///
/// attenuation  constant (1), linear (1/m), quadratic (1/m^2): finite, >= 0, not all zero
/// fog.density  1/m, >= 0; 0 is clear air (0), infinity is total fog (attenuation at 0+)
/// threshold    (0, 1): attenuation at which the light ends
/// returns      [0, 1]
/// max error    kAxialAirlightMaxUlp                                                                (airlight_test.cpp)
/// throws       std::invalid_argument naming field, value and rule
double axial_airlight(const Attenuation& attenuation, const Fog& fog, double threshold = kDefaultThreshold);

/// Airlight of a light along its own axis, in the fog that its class sees.
///
/// throws  std::invalid_argument naming field, value and rule
double axial_airlight(const Light& light, const Fog& fog);

}  // namespace litfog
