// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "litfog/airlight.h"
#include "model/density_profile_text.h"
#include "model/packed_cone.h"
#include "model/phase_text.h"
#include "model/unchecked.h"

// The airlight's formulas as C++: the text that the shaders share (litfog/shaders/airlight.glsl), and its arguments.

namespace litfog::airlight_text {

using namespace formulas;  // those of cone_profile.glsl
using namespace phase_text;
using glm::sign;
using std::abs, std::asinh, std::ceil, std::clamp, std::exp, std::floor, std::log, std::max, std::min, std::pow, std::sqrt;

/// a b - c d without cancellation (William Kahan's, as in Claude-Pierre Jeannerod, Nicolas Louvet and Jean-Michel
/// Muller 2013, "Further analysis of Kahan's algorithm for the accurate computation of 2x2 determinants").
template <typename Real>
Real difference_of_products(Real a, Real b, Real c, Real d) {
  const Real cd = c * d;
  return std::fma(a, b, -cd) + std::fma(-c, d, cd);
}

template <typename Real>
glm::vec<3, Real> cross_without_cancellation(const glm::vec<3, Real>& a, const glm::vec<3, Real>& b) {
  return {difference_of_products(a.y, b.z, a.z, b.y), difference_of_products(a.z, b.x, a.x, b.z),
          difference_of_products(a.x, b.y, a.y, b.x)};
}

template <typename Real>
inline constexpr BasicDensityProfile<Real> kNoLayers{};

/// Cookie  called with a distance along the ray from its closest approach to the light: the fraction of the light's
///         axial intensity there, for LITFOG_PROFILE_COOKIE
template <typename Real, typename Cookie>
struct Text {
  using LitfogPhase = PackedPhase<Real>;
  const Cookie& cookie;
  const BasicDensityProfile<Real>& layers = kNoLayers<Real>;

  DensityProfileText<Real> layers_text() const { return {layers}; }
  int litfog_knot_count() const { return int(layers.count); }
  Real litfog_knot_height(int i) const { return layers.knots[std::size_t(i)].height; }
  Real litfog_knot_density(int i) const { return layers.knots[std::size_t(i)].density; }
  Real litfog_profile_density(Real height) const { return layers_text().litfog_profile_density(height); }
  Real litfog_mean_density(Real a, Real b) const { return layers_text().litfog_mean_density(a, b); }
  Real litfog_largest_profile_density() const { return layers_text().litfog_largest_profile_density(); }

  struct LitfogAirlight;
  Real litfog_airlight_cookie(const LitfogAirlight&, Real along) const { return cookie(along); }

#define LITFOG_COOKIES
#define LITFOG_REAL Real
#define LITFOG_CONSTANT static constexpr
#define litfog_expm1 std::expm1
#define litfog_denominator formulas::denominator
#define litfog_is_exp formulas::is_exp
#define litfog_attenuation formulas::attenuation
#include "litfog/shaders/airlight.glsl"  // undefines LITFOG_REAL and LITFOG_CONSTANT
#undef litfog_expm1
#undef litfog_denominator
#undef litfog_is_exp
#undef litfog_attenuation
#undef LITFOG_COOKIES

  /// A light's parameters along a ray, in the fog that the light's class sees.
  LitfogAirlight seen_along(const PlacedLight& placed, Real extent, const Fog& class_fog, const EyeRay& ray,
                            LampLeg lamp_leg, const LitfogPhase& phase) const {
    using Vector = glm::vec<3, Real>;
    const Light& light = placed.light;
    const Vector stated = Vector(ray.direction);
    const Vector direction = glm::normalize(stated);
    const Vector axis = glm::normalize(Vector(placed.direction));
    const Vector to_light = Vector(placed.position) - Vector(ray.origin);
    const Real approach = glm::dot(to_light, direction);
    // From the light to the closest approach: approach * direction - to_light, which a ray through the light would
    // leave as rounding alone.
    const Vector offset = glm::cross(cross_without_cancellation(to_light, stated), stated) / glm::dot(stated, stated);
    LitfogAirlight air{};
    air.density = Real(class_fog.density);
    air.mode = Real(class_fog.mode);
    air.lamp_leg = lamp_leg == LampLeg::fogged ? 1 : 0;
    air.phase = phase;
    air.constant = Real(light.attenuation.constant);
    air.linear = Real(light.attenuation.linear);
    air.quadratic = Real(light.attenuation.quadratic);
    air.extent = extent;
    const PackedCone<Real> cone = packed_cone<Real>(light.cone);
    air.profile = cone.profile;
    air.cone_x = cone.x;
    air.cone_y = cone.y;
    air.ray_length = Real(ray.length);
    air.approach = approach;
    air.offset = glm::length(offset);
    air.axis_offset = glm::dot(offset, axis);
    air.axis_slope = glm::dot(direction, axis);
    air.layer_scale = layers.count > 0 ? Real(light.density_scale) : Real(0);
    air.rise = std::abs(direction.y) > Real(kLevelRise) ? direction.y : Real(0);
    air.height = Real(ray.origin.y) + approach * air.rise;
    air.lamp_height = Real(placed.position.y);
    return air;
  }

  /// The limit of total fog: light is scattered at the eye itself.
  Real at_the_eye(const LitfogAirlight& air) {
    const Real range = litfog_airlight_range(air, air.approach);
    const bool is_dark = air.ray_length == 0 || range >= air.extent || (air.lamp_leg != 0 && range > 0);
    if (is_dark) return 0;
    const Real phase = litfog_phase(air.phase, range > 0 ? litfog_airlight_versine(air, -air.approach, range) : Real(2));
    // With the eye in the lamp itself f dims both legs alike: the integral of -f' f is 1/2.
    const Real through = air.lamp_leg != 0 ? Real(0.5) : Real(1);
    return through * formulas::attenuation(range, air.constant, air.linear, air.quadratic) * phase *
           litfog_airlight_beam(air, -air.approach, range);
  }
};

/// Stands for no cookie.
struct NoCookie {
  template <typename Real>
  Real operator()(Real) const {  // GCOV_EXCL_START: of lights with a cookie alone
    return 1;
  }  // GCOV_EXCL_STOP
  template <typename Cuts>
  void append_kinks(Cuts&) const {}
};

}  // namespace litfog::airlight_text
