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

/// Whether fog dims light on the lamp's leg: its path from the lamp to where it is scattered.
enum class LampLeg {
  clear,  ///< k = 0: no loss on this leg, as in Hales's model, which dims only the eye's leg
  fogged  ///< k = 1: the fog factor f(r) dims light on this leg (single scattering)
};

/// A ray from the eye to what it sees. World space, metres.
struct EyeRay {
  glm::dvec3 origin{0.0};                                   ///< each coordinate at most kMaxPosition in magnitude
  glm::dvec3 direction{0.0, 0.0, -1.0};                     ///< its length is 1 within kDirectionTolerance
  double length = std::numeric_limits<double>::infinity();  ///< D, >= 0: to the surface or the end of the fog
};

/// What is wrong with a ray, or nothing.
std::optional<ValueError> find_error(const EyeRay& ray);

/// In layers, a ray that rises or falls by no more than this, in metres per metre, counts as level. It would reach
/// another layer so far away that doubles cannot tell where.
inline constexpr double kLevelRise = 1e-12;

/// Largest errors of airlight(), from clear air to a visibility of 5 cm, for cones of at least 0.1 degree,
/// |g| <= 0.99 and Phase::droplets().
///
/// | light              | fog       | bound                                                      | test           |
/// |--------------------|-----------|------------------------------------------------------------|----------------|
/// | any                | exp, exp2 | kAirlightMaxError in every ray                             | airlight_climb |
/// | point              | exp       | kShapedAirlightMaxError instead, unless isotropic          | airlight_climb |
/// | cone               | exp       | kShapedConeAirlightMaxError instead, unless isotropic      | airlight_climb |
/// | point              | layers    | kShapedAirlightMaxError in every ray, unless isotropic     | airlight_climb |
/// | any other          | layers    | kLayeredAirlightMaxError in every ray                      | airlight_climb |
/// | point              | exp, exp2 | kAirlightTypicalError in 99 of 100 rays                    | airlight_test  |
/// | cone               | exp, exp2 | kAirlightTypicalError in 99 of 100 rays above kDimAirlight | airlight_test  |
/// | photometric        | exp, exp2 | kPhotometricAirlightMaxError in every ray                  | airlight_test  |
///
/// kAirlightTypicalError also holds in layers. kPhotometricAirlightMaxError holds in layers of droplets or isotropic
/// layers, if the lamp is in or beside one and the lamp's leg is fogged.
///
/// The first five bounds are fractions of the lamp's colour, or of the airlight where that is above 1. The others are
/// fractions of the airlight. Their rays are random, or pass a light at one angle (0.1 to 179 degrees) and distance
/// from the eye (0.02 to 4 fog scales, 1 / density); there, rays of a point whose airlight is below 1e-12 do not count.
/// A photometric light has a source radius of 0.02 to 2 m and is up to 1e5 times as bright as white. It counts where
/// its colour times its airlight is above kDimPhotometricAirlight, a quarter of an 8-bit step. A cone's airlight below
/// kDimAirlight is rounding at the cone's outermost edge. No 8-bit display shows it unless the lamp is over a million
/// times as bright as white.
inline constexpr double kAirlightMaxError = 1 / 255.;
inline constexpr double kShapedAirlightMaxError = 0.1;
inline constexpr double kShapedConeAirlightMaxError = 3 / 255.;
inline constexpr double kLayeredAirlightMaxError = 5 / 255.;
inline constexpr double kAirlightTypicalError = 0.01;
inline constexpr double kPhotometricAirlightMaxError = 0.035;
inline constexpr double kDimPhotometricAirlight = 1e-3;
inline constexpr double kDimAirlight = 1e-10;

/// Factor from colour times airlight to picture values, for albedo 1 and for an atmosphere. A white surface that a lamp
/// lights with E lux at normal incidence has the radiance E / pi; isotropic fog of albedo 1 scatters E / (4 pi).
inline constexpr double kAirlightUnit = 0.25;
inline double airlight_unit(const Atmosphere& atmosphere) { return kAirlightUnit * atmosphere.albedo; }

/// Airlight of a light along a ray: the fraction of the light's colour that the fog scatters into the eye,
///   A = integral over s in [0, D] of  -f'(s) a(r) cone(u) f(r)^k phase(theta)  ds
/// where s is the distance from the eye, r and u are range and angle from the light, theta is the scattering angle,
/// and a(r) = 0 beyond the light's extent. The phase function is relative to the isotropic one.
///
/// light      ends at its threshold; sees the fog's density times its density scale
/// atmosphere its top does not cut rays: their lengths do
/// returns    [0, 1] in isotropic fog, otherwise up to largest_phase()
/// max error  the table above                                                                       (airlight_test.cpp)
/// throws     std::invalid_argument naming field, value and rule
double airlight(const PlacedLight& light, const Atmosphere& atmosphere, const EyeRay& ray,
                LampLeg lamp_leg = LampLeg::fogged);

/// Airlight along many rays. Spans of different lengths are a caller's bug and assert.
///
/// throws     std::invalid_argument naming field, value and rule, before any result is written
void airlight(const PlacedLight& light, const Atmosphere& atmosphere, std::span<const EyeRay> rays, LampLeg lamp_leg,
              std::span<double> airlights);

/// Largest error of reference_airlight for |g| up to 0.99: this fraction of the airlight or, for a spot, 1e-19 of its
/// airlight without the cone, whichever is larger. A ray may stay beyond the fraction 1 - x of a light's extent; its
/// error is then up to kGrazingReferenceAirlightError / x of the airlight, if that is larger (x below 1e-8).
inline constexpr double kReferenceAirlightMaxError = 1e-10;
inline constexpr double kGrazingReferenceAirlightError = 1e-18;

/// Airlight by adaptive quadrature, split wherever the integrand is not smooth. For tests and comparisons: it takes
/// some 50 to 150 times as long as airlight() (`litfog-bench airlight`) and allocates.
///
/// max error  kReferenceAirlightMaxError                                                            (airlight_test.cpp)
/// throws     std::invalid_argument naming field, value and rule
double reference_airlight(const PlacedLight& light, const Atmosphere& atmosphere, const EyeRay& ray,
                          LampLeg lamp_leg = LampLeg::fogged);

/// Largest error of picture_airlight: this fraction of the airlight or, for a spot, 1e-16 of its airlight without the
/// cone, whichever is larger. A ray that stays beyond the fraction 1 - 1e-8 of a light's extent may err by more.
inline constexpr double kPictureAirlightMaxError = 1e-6;

/// reference_airlight in double, for reference pictures, where its error is 0.0003 steps of a display at most: five to
/// eight times as fast.
///
/// max error  kPictureAirlightMaxError                                                              (airlight_test.cpp)
/// throws     std::invalid_argument naming field, value and rule
double picture_airlight(const PlacedLight& light, const Atmosphere& atmosphere, const EyeRay& ray,
                        LampLeg lamp_leg = LampLeg::fogged);

/// Upper bound of a light's airlight along rays of any length from the eye, within an angle of an axis. It allows
/// skipping a light for a tile of the picture, or for all of it.
///
/// Proof. The phase function is at most p = largest_phase() and the cone 1. Let R be the light's range from the eye,
/// and h its distance to the cone of rays: R times the sine of the angle by which the light lies outside the cone, R
/// where that angle is over 90 degrees, 0 inside. No point of the rays is nearer to the light than h. a falls with
/// range, so it is at most a(h), and 0 where h is not below the extent E. The lit stretch of a ray is a chord of
/// the sphere of radius E: it is at most c = 2 sqrt(E^2 - h^2) long, and begins at least s0 = max(0, R - E) from the
/// eye. Hence
///   A <= p a(h) f(s0) (1 - f(c))                 in exp fog, f(s0) in the thinnest of it and f(c) in the thickest;
///   A <= p a(h) min(f(s0), c d sqrt(2 / e))      in exp2 fog, where -f' is at most d sqrt(2 / e).
/// With the lamp's leg fogged the integrand has the factor f(r) as well, and f(r) <= f(h) in the thinnest fog.
/// Rounding: h is lowered, and the rest raised, by the fraction 1e-12.
/// The bounds of litfog/shaders/airlight_bound.glsl are looser: they do not know f(s0), nor that fog ends.
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
/// Proof. a and f fall with range, and so does their product: once below the budget, it stays below. The range returned
/// is the extent, or the upper end of a bisection, where the product is below the budget.
///
/// fog      in layered air Atmosphere::thinnest_fog()
/// budget   (0, 1): a fraction of the largest component of the light's colour
/// returns  metres, [0, extent], too long by at most the fraction 1e-9 (airlight_test.cpp); infinite for constant
///          attenuation above the budget in clear air or with the lamp's leg clear
/// throws   std::invalid_argument naming field, value and rule
double light_reach(const Light& light, const Fog& fog, double budget, LampLeg lamp_leg = LampLeg::fogged);

/// The budget of light_reach() at which everything that lights add beyond their reach stays below a step of a picture.
///
/// Proof. A light of budget b and brightness c adds less than b c to a surface beyond its reach, because a f < b there.
/// It adds less than p b c to the fog in front of the surface, where p is airlight_unit() times largest_phase(),
/// because the integral of -f' is at most 1. All lights together add less than their number times (1 + p) b c.
///
/// step        linear light, finite, > 0; surfaces must reflect at most what they receive, diffuse and specular
/// lights      number of lights in the scene
/// brightness  the largest component of the light's colour, finite, >= 0
/// returns     (0, 0.5]
/// throws      std::invalid_argument naming field, value and rule
double reach_budget(double step, std::size_t lights, double brightness, const Atmosphere& atmosphere);

/// Largest error of axial_airlight in ulp.
inline constexpr double kAxialAirlightMaxUlp = 3;

/// Airlight of a light along its own axis, with the eye at the light and the lamp's leg clear, out to the extent,
///   A = integral of a(r) d(1 - f(r)) over [0, extent].
/// The fog colour intensity (solve.h) is the largest rectangle under a over 1 - f, so A is never less.
///
/// attenuation  constant (1), linear (1/m), quadratic (1/m^2): finite, >= 0, not all zero
/// fog.density  1/m, >= 0; 0 is clear air (0), infinity is total fog (attenuation at 0+)
/// threshold    (0, 1): attenuation at which the light ends
/// returns      [0, 1]
/// max error    kAxialAirlightMaxUlp                                                                (airlight_test.cpp)
/// throws       std::invalid_argument naming field, value and rule
double axial_airlight(const Attenuation& attenuation, const Fog& fog, double threshold = kDefaultThreshold);

/// Airlight of a light along its own axis, in fog scaled by its density scale.
///
/// throws  std::invalid_argument naming field, value and rule
double axial_airlight(const Light& light, const Fog& fog);

}  // namespace litfog
