// SPDX-License-Identifier: Apache-2.0
// litfog: the light that the fog scatters from a lamp into the eye along a ray (airlight, single scattering):
//
//   A = integral over s in [0, D] of  -f'(s) a(r) cone(u) f(r)^k phase(theta)  ds
//
// s from the eye, r and u the range and angle from the lamp, theta the angle of scattering. GLSL includes this file
// like any other; C++ takes the same text through src/airlight/airlight_text.h.
//
// Method. Along the ray, x is the distance from the closest approach to the lamp. The part of the ray that can
// contribute (inside extent, cone and the fog's reach) is cut where the integrand is not smooth: at the closest
// approach, at the ends of the plateau (where the attenuation is clamped to 1), at the edges of a cone and, for a beam
// that crosses the ray, at its middle. On each piece Gauss-Legendre nodes are evenly spread in
//   t = asinh(z / w),  z = (1 - e^(-q (x - x0))) / q,
// in which both the falloff of the lamp (of width w) and that of the fog (of rate q) are nearly straight; x0 is where
// the lit part begins on that side. A point lamp in isotropic fog has a closed form on the plateau and takes 7 nodes
// elsewhere, which lie closer where its light is brighter, 8 in exp2 fog; a beam takes some 20, one wider than 90
// degrees some 28, a cookie some 128 (light_airlight.glsl chooses by what the lamp can show). Each piece takes at least
// 5 of them and a fifth, so that a bright piece short in t is not left to one.
//
// Where a phase function shapes the integrand in exp fog, q is 0 and a point lamp takes 8 nodes a side, bent towards
// the closest approach where the ray passes inside the falloff. It takes 12 where the ray meets the plateau or fog
// scatters back. In layers the ray is also cut at their knots, and each piece of it into steps of some optical depths,
// from the end that the fog hides least to where it hides the rest.
//
// Errors and what they were measured on: litfog/airlight.h. In floats they hold for cones of at least 0.02 radians and
// lamps within 4e5 fog scales, for a float has too few digits of the cosine of a narrower cone and of a longer range;
// the relative error holds for airlight above 1e-5.
//
// Loops test at their end. Drivers without branches (llvmpipe) run a body once more, for nothing, to find out at its
// beginning that the loop has ended.
//
// A program whose lamps all have C >= 1 has no plateaus. If it defines LITFOG_NO_KNEE before the first include of
// litfog, compilers leave their closed forms out.

#ifndef LITFOG_AIRLIGHT_GLSL
#define LITFOG_AIRLIGHT_GLSL

#include "litfog/shaders/airlight_bound.glsl"
#include "litfog/shaders/cone_profile.glsl"
#ifndef __cplusplus
#include "litfog/shaders/density_profile.glsl"
#endif
#include "litfog/shaders/formulas.glsl"
#include "litfog/shaders/phase.glsl"

#ifndef __cplusplus
#define LITFOG_REAL float
#define LITFOG_CONSTANT const
#endif

// A lamp as a ray sees it, and the fog.
struct LitfogAirlight {
  LITFOG_REAL density;   // of the fog without layers as the lamp's class sees it, 1/m
  LITFOG_REAL mode;      // of the fog: litfog_is_exp()
  LITFOG_REAL lamp_leg;  // k: 1 where the light loses f(r) on its way from the lamp, 0 where it does not
  LitfogPhase phase;
  LITFOG_REAL constant;  // of the attenuation
  LITFOG_REAL linear;
  LITFOG_REAL quadratic;
  LITFOG_REAL extent;   // metres
  LITFOG_REAL profile;  // of the cone, with its x and y: LITFOG_PROFILE_*
  LITFOG_REAL cone_x;
  LITFOG_REAL cone_y;
  LITFOG_REAL ray_length;   // D, metres
  LITFOG_REAL approach;     // metres from the eye to the closest approach; below 0 where that is behind the eye
  LITFOG_REAL offset;       // metres from the closest approach to the lamp
  LITFOG_REAL axis_offset;  // component of that offset along the cone's axis: lamp to closest approach
  LITFOG_REAL axis_slope;   // cosine between the ray and the cone's axis
  LITFOG_REAL nodes;        // how often the integrand is evaluated; 0: as often as the stated errors need
  LITFOG_REAL layer_scale;  // of the density profile (density_profile.glsl) for the lamp's class; 0: no layers
  LITFOG_REAL height;       // metres: of the closest approach
  LITFOG_REAL rise;         // of the ray, metres a metre
  LITFOG_REAL lamp_height;  // metres
};

LITFOG_CONSTANT LITFOG_REAL litfog_far = LITFOG_REAL(1.0e30);  // stands for infinity

// Nodes and weights of Gauss and Legendre on [0, 1]: 1 to 8 nodes, one rule after the other.
#ifdef __cplusplus
#define LITFOG_TABLE = {
#define LITFOG_TABLE_END };
#else
#define LITFOG_TABLE = float[](
#define LITFOG_TABLE_END );
#endif
LITFOG_CONSTANT LITFOG_REAL litfog_gauss_nodes[36] LITFOG_TABLE
    0.5,
    0.2113248654051871, 0.7886751345948129,
    0.1127016653792583, 0.5, 0.8872983346207417,
    0.06943184420297371, 0.3300094782075719, 0.6699905217924281, 0.9305681557970263,
    0.046910077030668, 0.2307653449471585, 0.5, 0.7692346550528415, 0.953089922969332,
    0.03376524289842399, 0.1693953067668677, 0.3806904069584015, 0.6193095930415985, 0.8306046932331323,
    0.966234757101576,
    0.02544604382862074, 0.1292344072003028, 0.2970774243113014, 0.5, 0.7029225756886986, 0.8707655927996972,
    0.9745539561713793,
    0.01985507175123188, 0.1016667612931866, 0.2372337950418355, 0.4082826787521751, 0.5917173212478249,
    0.7627662049581645, 0.8983332387068134, 0.9801449282487681
LITFOG_TABLE_END
LITFOG_CONSTANT LITFOG_REAL litfog_gauss_weights[36] LITFOG_TABLE
    1.0,
    0.5, 0.5,
    0.2777777777777778, 0.4444444444444444, 0.2777777777777778,
    0.1739274225687269, 0.3260725774312731, 0.3260725774312731, 0.1739274225687269,
    0.1184634425280945, 0.2393143352496832, 0.2844444444444444, 0.2393143352496832, 0.1184634425280945,
    0.08566224618958517, 0.1803807865240693, 0.2339569672863455, 0.2339569672863455, 0.1803807865240693,
    0.08566224618958517,
    0.06474248308443485, 0.1398526957446383, 0.1909150252525595, 0.2089795918367347, 0.1909150252525595,
    0.1398526957446383, 0.06474248308443485,
    0.05061426814518813, 0.1111905172266872, 0.1568533229389436, 0.181341891689181, 0.181341891689181,
    0.1568533229389436, 0.1111905172266872, 0.05061426814518813
LITFOG_TABLE_END

// Range from the lamp at a distance along the ray from the closest approach.
LITFOG_REAL litfog_airlight_range(LitfogAirlight air, LITFOG_REAL along) {
  return sqrt(air.offset * air.offset + along * along);
}

// Cosine from the cone's axis there; in the lamp itself that of the ray onward. Where the ray meets the lamp, the
// offset is all rounding and the quotient can exceed 1 by far.
LITFOG_REAL litfog_airlight_cosine(LitfogAirlight air, LITFOG_REAL along, LITFOG_REAL range) {
  return range > LITFOG_REAL(0.0)
             ? clamp((air.axis_offset + air.axis_slope * along) / range, LITFOG_REAL(-1.0), LITFOG_REAL(1.0))
             : air.axis_slope;
}

#if defined(LITFOG_COOKIES) && !defined(__cplusplus)
// The including program's: fraction of the axial intensity at a distance along the ray from the closest approach.
LITFOG_REAL litfog_airlight_cookie(LitfogAirlight air, LITFOG_REAL along);
#endif

LITFOG_REAL litfog_airlight_beam(LitfogAirlight air, LITFOG_REAL along, LITFOG_REAL range) {
#ifdef LITFOG_COOKIES
  if (air.profile == LITFOG_REAL(LITFOG_PROFILE_COOKIE)) return litfog_airlight_cookie(air, along);
#endif
  if (!litfog_has_cone(air.profile)) return LITFOG_REAL(1.0);
  return litfog_cone_at(air.profile, litfog_airlight_cosine(air, along, range), air.cone_x, air.cone_y);
}

// 1 - cosine of the angle of scattering there, in which no digits cancel on either side of the lamp.
LITFOG_REAL litfog_airlight_versine(LitfogAirlight air, LITFOG_REAL along, LITFOG_REAL range) {
  return along < LITFOG_REAL(0.0) ? air.offset * air.offset / (range * (range - along)) : (range + along) / range;
}

// What of the integrand depends on angles, but for the edge of a cone and for a cookie.
LITFOG_REAL litfog_airlight_by_angles(LitfogAirlight air, LITFOG_REAL along) {
  LITFOG_REAL range = litfog_airlight_range(air, along);
  LITFOG_REAL value =
      range > LITFOG_REAL(0.0) ? litfog_phase(air.phase, litfog_airlight_versine(air, along, range)) : LITFOG_REAL(1.0);
  if (!litfog_cone_is_cut_off(air.profile)) return value;
  LITFOG_REAL cosine = litfog_airlight_cosine(air, along, range);
  return value * litfog_cone_at(air.profile, cosine, LITFOG_REAL(0.0), air.cone_y);
}

// Whether there are layers of fog.
bool litfog_airlight_is_layered(LitfogAirlight air) {
#ifdef LITFOG_KNOT_COUNT
  return LITFOG_KNOT_COUNT > 0;
#endif
  return air.layer_scale > LITFOG_REAL(0.0) && litfog_knot_count() > 0;
}

// Height at a distance along the ray from the closest approach.
LITFOG_REAL litfog_airlight_height(LitfogAirlight air, LITFOG_REAL along) { return air.height + air.rise * along; }

// Density there, in layers.
LITFOG_REAL litfog_airlight_density(LitfogAirlight air, LITFOG_REAL along) {
  return air.density + air.layer_scale * litfog_profile_density(litfog_airlight_height(air, along));
}

// Optical depth of both legs there, in layers.
LITFOG_REAL litfog_airlight_depth(LitfogAirlight air, LITFOG_REAL along) {
  LITFOG_REAL height = litfog_airlight_height(air, along);
  LITFOG_REAL seen = max(air.approach + along, LITFOG_REAL(0.0));
  LITFOG_REAL lit = air.lamp_leg * litfog_airlight_range(air, along);
  LITFOG_REAL on_seen = litfog_mean_density(litfog_airlight_height(air, -air.approach), height);
  LITFOG_REAL on_lit = litfog_mean_density(air.lamp_height, height);
  return air.density * (seen + lit) + air.layer_scale * (on_seen * seen + on_lit * lit);
}

// The integrand at a distance along the ray from the closest approach.
LITFOG_REAL litfog_airlight_integrand(LitfogAirlight air, LITFOG_REAL along) {
  LITFOG_REAL range = litfog_airlight_range(air, along);
  LITFOG_REAL seen = max(air.approach + along, LITFOG_REAL(0.0));
  LITFOG_REAL lit = air.lamp_leg * range;
  LITFOG_REAL weight;
  LITFOG_REAL density = air.density;
  if (litfog_airlight_is_layered(air)) {
    weight = exp(-litfog_airlight_depth(air, along));
    density = litfog_airlight_density(air, along);
  } else if (litfog_is_exp(air.mode)) {
    weight = exp(-air.density * (seen + lit));
  } else {
    LITFOG_REAL x = air.density * seen;
    LITFOG_REAL y = air.density * lit;
    weight = LITFOG_REAL(2.0) * x * exp(-x * x - y * y);
  }
  weight *= density * litfog_attenuation(range, air.constant, air.linear, air.quadratic);
  if (!litfog_is_isotropic(air.phase) && range > LITFOG_REAL(0.0)) {
    weight *= litfog_phase(air.phase, litfog_airlight_versine(air, along, range));
  }
  return weight * litfog_airlight_beam(air, along, range);
}

// x e^x E1(x), E1 being the exponential integral, x >= 0. Largest error 3e-7 (Abramowitz and Stegun 1964, "Handbook of
// Mathematical Functions", 5.1.53 and 5.1.56).
LITFOG_REAL litfog_scaled_e1(LITFOG_REAL x) {
  if (x <= LITFOG_REAL(0.0)) return LITFOG_REAL(0.0);
  if (x < LITFOG_REAL(1.0)) {
    LITFOG_REAL series =
        LITFOG_REAL(-0.57721566) +
        x * (LITFOG_REAL(0.99999193) +
             x * (LITFOG_REAL(-0.24991055) +
                  x * (LITFOG_REAL(0.05519968) + x * (LITFOG_REAL(-0.00976004) + x * LITFOG_REAL(0.00107857)))));
    return x * exp(x) * (series - log(x));
  }
  LITFOG_REAL above =
      LITFOG_REAL(0.2677737343) +
      x * (LITFOG_REAL(8.6347608925) + x * (LITFOG_REAL(18.0590169730) + x * (LITFOG_REAL(8.5733287401) + x)));
  LITFOG_REAL below =
      LITFOG_REAL(3.9584969228) +
      x * (LITFOG_REAL(21.0996530827) + x * (LITFOG_REAL(25.6329561486) + x * (LITFOG_REAL(9.5733223454) + x)));
  return x > LITFOG_REAL(1.0e6) ? LITFOG_REAL(1.0) : above / below;
}

// Error function. Largest error 2e-7 (Abramowitz and Stegun, 7.1.26).
LITFOG_REAL litfog_erf(LITFOG_REAL x) {
  LITFOG_REAL size = abs(x);
  LITFOG_REAL t = LITFOG_REAL(1.0) / (LITFOG_REAL(1.0) + LITFOG_REAL(0.3275911) * size);
  LITFOG_REAL series =
      t * (LITFOG_REAL(0.254829592) +
           t * (LITFOG_REAL(-0.284496736) +
                t * (LITFOG_REAL(1.421413741) + t * (LITFOG_REAL(-1.453152027) + t * LITFOG_REAL(1.061405429)))));
  LITFOG_REAL size_of_erf = LITFOG_REAL(1.0) - series * exp(-min(size, LITFOG_REAL(9.0)) * min(size, LITFOG_REAL(9.0)));
  return x < LITFOG_REAL(0.0) ? -size_of_erf : size_of_erf;
}

// An antiderivative of the integrand in isotropic fog where attenuation and cone are 1. In exp fog with the lamp's leg,
// v = d (x + r) turns it into e^(-d approach - v) (1 + (d offset)^2 / v^2) / 2 dv.
LITFOG_REAL litfog_airlight_plateau(LitfogAirlight air, LITFOG_REAL along) {
  LITFOG_REAL d = air.density;
  if (litfog_is_exp(air.mode)) {
    if (air.lamp_leg == LITFOG_REAL(0.0))
      return litfog_expm1(-d * max(air.approach + along, LITFOG_REAL(0.0))) * LITFOG_REAL(-1.0);
    LITFOG_REAL larger = litfog_airlight_range(air, along) + abs(along);
    LITFOG_REAL smaller = larger > LITFOG_REAL(0.0) ? air.offset * air.offset / larger : LITFOG_REAL(0.0);
    LITFOG_REAL v = d * (along < LITFOG_REAL(0.0) ? smaller : larger);
    LITFOG_REAL mirrored = d * (along < LITFOG_REAL(0.0) ? larger : smaller);  // (d offset)^2 / v
    LITFOG_REAL bracket = LITFOG_REAL(1.0) + mirrored * (LITFOG_REAL(1.0) - litfog_scaled_e1(v));
    return LITFOG_REAL(-0.5) * bracket * exp(-d * air.approach - v);
  }
  LITFOG_REAL x = d * max(air.approach + along, LITFOG_REAL(0.0));
  if (air.lamp_leg == LITFOG_REAL(0.0)) return litfog_expm1(-x * x) * LITFOG_REAL(-1.0);
  LITFOG_REAL half_way = LITFOG_REAL(0.5) * d * air.approach;
  LITFOG_REAL y = d * litfog_airlight_range(air, along);
  LITFOG_REAL at_half_way = LITFOG_REAL(2.0) * half_way * half_way + d * air.offset * d * air.offset;
  return LITFOG_REAL(-0.5) * exp(-x * x - y * y) + LITFOG_REAL(1.2533141373155) * half_way * exp(-at_half_way) *
                                                       litfog_erf(LITFOG_REAL(1.4142135623731) * (x - half_way));
}

// Distance along the ray from the closest approach to where the lamp is at a range; 0 if the ray passes farther away.
LITFOG_REAL litfog_airlight_chord(LitfogAirlight air, LITFOG_REAL range) {
  return range > air.offset ? sqrt(range - air.offset) * sqrt(range + air.offset) : LITFOG_REAL(0.0);
}

// Range at which the denominator C + L r + Q r^2 has a value.
LITFOG_REAL litfog_level_range(LITFOG_REAL value, LITFOG_REAL constant, LITFOG_REAL linear, LITFOG_REAL quadratic) {
  LITFOG_REAL rise = value - constant;
  if (rise <= LITFOG_REAL(0.0)) return LITFOG_REAL(0.0);
  LITFOG_REAL below = linear + sqrt(linear * linear + LITFOG_REAL(4.0) * quadratic * rise);
  return below * litfog_far > LITFOG_REAL(2.0) * rise ? LITFOG_REAL(2.0) * rise / below : litfog_far;
}

LITFOG_REAL litfog_airlight_level(LitfogAirlight air, LITFOG_REAL value) {
  return litfog_level_range(value, air.constant, air.linear, air.quadratic);
}

// A part of the ray's line, as distances from the closest approach to the lamp; empty unless high > low.
struct LitfogAirlightPart {
  LITFOG_REAL low;
  LITFOG_REAL high;
};

// The part of the ray's line inside a convex cone about the axis. Its half angle, at most a right one, is that of the
// cosine; for a cosine below 0 it is the opposite cone, which a beam wider than a right angle leaves dark. Ends are at
// -litfog_far and litfog_far where the line does not leave the cone.
//
// Everyone who needs to know what of a ray is lit asks here, so that rounding cannot give two answers. The sign of
// a = slope^2 - cosine^2 alone decides. Where it is above 0 the line runs from one nappe to the other: it is inside
// from its last crossing on (slope > 0) or up to its first. Else both crossings are on one nappe, that of axis_offset.
LitfogAirlightPart litfog_airlight_inside(LitfogAirlight air, LITFOG_REAL cosine) {
  LITFOG_REAL sign_of_axis = cosine < LITFOG_REAL(0.0) ? LITFOG_REAL(-1.0) : LITFOG_REAL(1.0);
  LITFOG_REAL slope = sign_of_axis * air.axis_slope;
  LITFOG_REAL axis_offset = sign_of_axis * air.axis_offset;
  LITFOG_REAL c2 = cosine * cosine;
  LITFOG_REAL a = slope * slope - c2;
  LITFOG_REAL b = axis_offset * slope;
  LITFOG_REAL c = axis_offset * axis_offset - c2 * air.offset * air.offset;
  // b^2 - a c, without the difference: for wide cones both are nearly equal.
  LITFOG_REAL discriminant = c2 * (axis_offset * axis_offset + a * air.offset * air.offset);
  LitfogAirlightPart part;
  part.low = LITFOG_REAL(0.0);
  part.high = LITFOG_REAL(0.0);
  if (a <= LITFOG_REAL(0.0) && !(axis_offset > LITFOG_REAL(0.0) && discriminant >= LITFOG_REAL(0.0))) return part;
  LITFOG_REAL root = sqrt(max(discriminant, LITFOG_REAL(0.0)));
  LITFOG_REAL q = b < LITFOG_REAL(0.0) ? root - b : -b - root;
  LITFOG_REAL first = litfog_far;  // of the roots of a x^2 + 2 b x + c, infinite where the line is parallel to the edge
  if (abs(a) * litfog_far > abs(q)) {
    first = q / a;
  } else if ((q < LITFOG_REAL(0.0)) == (a > LITFOG_REAL(0.0))) {
    first = -litfog_far;
  }
  LITFOG_REAL second = q != LITFOG_REAL(0.0) ? c / q : c > LITFOG_REAL(0.0) ? -litfog_far : LITFOG_REAL(0.0);
  part.low = min(first, second);
  part.high = max(first, second);
  if (a > LITFOG_REAL(0.0)) {
    LITFOG_REAL end = slope > LITFOG_REAL(0.0) ? part.high : part.low;
    part.low = slope > LITFOG_REAL(0.0) ? end : -litfog_far;
    part.high = slope > LITFOG_REAL(0.0) ? litfog_far : end;
  }
  return part;
}

// Whether the cone is wider than a right angle, so that it lights all but one part of the ray's line.
bool litfog_airlight_is_wide(LitfogAirlight air) {
  return litfog_has_cone(air.profile) && air.cone_x < LITFOG_REAL(0.0);
}

// A point lamp in isotropic fog without layers.
bool litfog_airlight_is_plain(LitfogAirlight air) {
  return air.profile == LITFOG_REAL(LITFOG_PROFILE_NONE) && litfog_is_isotropic(air.phase) &&
         !litfog_airlight_is_layered(air);
}

// A lamp in exp fog that is not isotropic and dims the lamp's leg as it does the eye's: the fog's weight e^(-d (s + r))
// is then nearly the same on all of the ray before the lamp, and the phase function shapes the integrand.
bool litfog_airlight_is_shaped(LitfogAirlight air) {
  return !litfog_is_isotropic(air.phase) && litfog_is_exp(air.mode) && air.lamp_leg > LITFOG_REAL(0.0) &&
         !litfog_airlight_is_layered(air) && air.profile != LITFOG_REAL(LITFOG_PROFILE_COOKIE);
}

// The number of nodes of the stated errors.
LITFOG_REAL litfog_airlight_nodes(LitfogAirlight air) {
  if (litfog_airlight_is_plain(air)) {
    // A far lamp may make two peaks: the fog before the eye and that around the lamp. In exp fog with the lamp's leg
    // fogged all fog between them is as bright.
    LITFOG_REAL depth = air.density * air.approach;
    if (!litfog_is_exp(air.mode)) {
      return depth > LITFOG_REAL(2.5) && depth < LITFOG_REAL(6.0) ? LITFOG_REAL(16.0) : LITFOG_REAL(8.0);
    }
    return air.lamp_leg == LITFOG_REAL(0.0) && depth > LITFOG_REAL(2.5) ? LITFOG_REAL(24.0) : LITFOG_REAL(7.0);
  }
  if (air.profile == LITFOG_REAL(LITFOG_PROFILE_COOKIE)) {
    return litfog_is_isotropic(air.phase) ? LITFOG_REAL(128.0) : LITFOG_REAL(160.0);
  }
  // The knee cuts the ray, and a phase function that scatters back brightens it far beyond the lamp.
  bool is_uneven = litfog_denominator(air.offset, air.constant, air.linear, air.quadratic) < LITFOG_REAL(1.0) ||
                   litfog_backward_depths(air.phase) > LITFOG_REAL(0.0);
  LITFOG_REAL of_shaped_point = is_uneven ? LITFOG_REAL(24.0) : LITFOG_REAL(16.0);
  if (litfog_airlight_is_layered(air)) {  // of each piece
    if (litfog_has_cone(air.profile)) return LITFOG_REAL(24.0);
    return litfog_is_isotropic(air.phase) ? LITFOG_REAL(12.0) : of_shaped_point;
  }
  if (litfog_airlight_is_shaped(air)) {
    if (!litfog_has_cone(air.profile)) return of_shaped_point;
    return litfog_airlight_is_wide(air) ? LITFOG_REAL(56.0) : LITFOG_REAL(36.0);
  }
  if (!litfog_is_isotropic(air.phase)) {
    LITFOG_REAL peak = litfog_largest_phase(air.phase, LITFOG_REAL(0.0), LITFOG_REAL(2.0));
    return peak < LITFOG_REAL(200.0) ? LITFOG_REAL(64.0) : LITFOG_REAL(120.0);
  }
  return litfog_airlight_is_wide(air) ? LITFOG_REAL(28.0) : LITFOG_REAL(20.0);
}

// A stretch of the ray on one side of an anchor, the point from which x is measured.
struct LitfogAirlightSide {
  LITFOG_REAL anchor;     // along the ray from the closest approach
  LITFOG_REAL direction;  // 1 beyond it or -1 before it
  LITFOG_REAL nearest;    // x of the stretch
  LITFOG_REAL farthest;
  LITFOG_REAL rate;   // q of z
  LITFOG_REAL width;  // w of t
  LITFOG_REAL size;   // its length in t; 0 where there is none
  LITFOG_REAL part;   // its weight when nodes are shared out
  LITFOG_REAL bend;   // > -1: where it begins, nodes lie 1 + bend times as close in t as if they were evenly spread
};

LITFOG_REAL litfog_airlight_z(LitfogAirlightSide side, LITFOG_REAL x) {
  LITFOG_REAL z = max(x - side.nearest, LITFOG_REAL(0.0));
  return side.rate == LITFOG_REAL(0.0) ? z : -litfog_expm1(-side.rate * z) / side.rate;
}

LITFOG_REAL litfog_airlight_t(LitfogAirlightSide side, LITFOG_REAL x) {
  return asinh(litfog_airlight_z(side, x) / side.width);
}

// Rate q at which the fog dims the integrand along a side, 1/m: in exp fog that of a fog scale beyond the nearest end,
// in exp2 fog 0.6 of that at the nearest end. Towards the eye the fog brightens it, which is left to t. But in exp fog
// with a clear lamp leg q takes half of it, or t would spread so many nodes before the eye that too few were left close
// to the lamp. In exp2 fog q takes an eighth of it: the weight -f'(s) f(r)^k is about a Gaussian around a point between
// eye and lamp, from where most of the light of a far lamp comes, and t alone has hardly a node there.
LITFOG_REAL litfog_airlight_rate(LitfogAirlight air, LitfogAirlightSide side) {
  if (litfog_airlight_is_shaped(air)) return LITFOG_REAL(0.0);
  LITFOG_REAL along = side.anchor + side.direction * side.nearest;
  if (!litfog_is_exp(air.mode)) {
    LITFOG_REAL legs = air.approach + along + air.lamp_leg * along;
    LITFOG_REAL rate = side.direction * LITFOG_REAL(2.0) * air.density * air.density * legs;
    return rate > LITFOG_REAL(0.0) ? LITFOG_REAL(0.6) * rate
                                   : max(LITFOG_REAL(0.125) * rate, LITFOG_REAL(-8.0) / (side.farthest - side.nearest));
  }
  if (side.direction < LITFOG_REAL(0.0)) return LITFOG_REAL(0.5) * air.density * (air.lamp_leg - LITFOG_REAL(1.0));
  along += LITFOG_REAL(1.0) / air.density;
  return air.density * (LITFOG_REAL(1.0) + air.lamp_leg * along / litfog_airlight_range(air, along));
}

// The bend of a point lamp's side about the closest approach, whose farthest z is `end`: 0.15 times the logarithm of
// the ratio of its brightness per t where it begins to that where it ends, the fog left out. Where exp2 fog brightens a
// side towards the eye, nodes lie closer at its end.
LITFOG_REAL litfog_airlight_bend(LitfogAirlight air, LitfogAirlightSide side, LITFOG_REAL end) {
  if (!litfog_is_exp(air.mode) && side.rate < LITFOG_REAL(0.0)) return LITFOG_REAL(-0.32);
  LITFOG_REAL begins = litfog_airlight_range(air, side.nearest);
  LITFOG_REAL ends = litfog_airlight_range(air, side.nearest + end);
  LITFOG_REAL fall = litfog_attenuation(begins, air.constant, air.linear, air.quadratic) /
                     litfog_attenuation(ends, air.constant, air.linear, air.quadratic);
  LITFOG_REAL stretch = end / side.width;
  LITFOG_REAL squared = fall * fall / (LITFOG_REAL(1.0) + stretch * stretch);
  return LITFOG_REAL(0.075) * log(max(squared, LITFOG_REAL(1.0)));
}

// Metres over which a shaped lamp's side is smooth in fog of a density: before the closest approach the two legs make
// up for each other, beyond it both dim the light.
LITFOG_REAL litfog_airlight_shaped_scale(LITFOG_REAL density, bool beyond) {
  return (beyond ? LITFOG_REAL(0.3) : LITFOG_REAL(2.0)) / density;
}

// The bend of a shaped lamp's side: by the logarithm of the offset, over which the phase function changes, to the
// distance over which all else does, and falling again where that change is too short to count. A side that begins far
// from the closest approach has the fraction of it that is left. The numbers gave the smallest errors of those tried,
// over the lamps and phase functions of airlight_test.cpp.
LITFOG_REAL litfog_airlight_shaped_bend(LitfogAirlight air, LitfogAirlightSide side, LITFOG_REAL falloff,
                                        LITFOG_REAL density) {
  LITFOG_REAL scale =
      min(min(falloff, side.farthest), litfog_airlight_shaped_scale(density, side.direction > LITFOG_REAL(0.0)));
  LITFOG_REAL inside = log(max(scale, air.offset) / max(air.offset, LITFOG_REAL(1.0e-9) * scale));
  LITFOG_REAL left = LITFOG_REAL(1.0) - side.nearest / max(scale, LITFOG_REAL(1.0e-30));
  LITFOG_REAL bend = min(LITFOG_REAL(0.4) * inside, LITFOG_REAL(0.25) * (LITFOG_REAL(17.0) - inside));
  return clamp(bend, LITFOG_REAL(0.0), LITFOG_REAL(2.0)) * max(left, LITFOG_REAL(0.0));
}

LitfogAirlightSide litfog_airlight_side(LitfogAirlight air, LITFOG_REAL from, LITFOG_REAL to, LITFOG_REAL anchor,
                                        bool beyond, LITFOG_REAL width, LITFOG_REAL falloff) {
  LitfogAirlightSide side;
  side.anchor = anchor;
  side.direction = beyond ? LITFOG_REAL(1.0) : LITFOG_REAL(-1.0);
  side.nearest = max(beyond ? from - anchor : anchor - to, LITFOG_REAL(0.0));
  side.farthest = beyond ? to - anchor : anchor - from;
  side.rate = litfog_airlight_rate(air, side);
  // What brightens towards the far end makes up for some of the fog.
  bool may_brighten = litfog_backward_depths(air.phase) > LITFOG_REAL(0.0) || litfog_cone_is_cut_off(air.profile);
  if (may_brighten && side.rate > LITFOG_REAL(0.0) && side.farthest > side.nearest) {
    LITFOG_REAL half_size = LITFOG_REAL(0.5) * (side.farthest - side.nearest);
    LITFOG_REAL end = side.anchor + side.direction * side.farthest;
    LITFOG_REAL at_end = litfog_airlight_by_angles(air, end);
    LITFOG_REAL at_middle = litfog_airlight_by_angles(air, end - side.direction * half_size);
    LITFOG_REAL growth = log(max(at_end / max(at_middle, LITFOG_REAL(1.0e-30)), LITFOG_REAL(1.0)));
    side.rate = max(side.rate - growth / half_size, LITFOG_REAL(0.0));
  }
  // Within a fog scale no z is needed, and the logarithm of nearly 1 is noise in floats.
  if (abs(side.rate) * (side.farthest - side.nearest) < LITFOG_REAL(1.0)) side.rate = LITFOG_REAL(0.0);
  side.width = LITFOG_REAL(1.0);
  side.size = LITFOG_REAL(0.0);
  side.part = LITFOG_REAL(0.0);
  side.bend = LITFOG_REAL(0.0);
  if (side.farthest > side.nearest) {
    LITFOG_REAL end = litfog_airlight_z(side, side.farthest);
    side.width =
        clamp(sqrt(width * width + side.nearest * side.nearest), LITFOG_REAL(1.0e-6) * end, LITFOG_REAL(1000.0) * end);
    side.size = asinh(end / side.width);
    side.part = sqrt(side.size);
    if (litfog_airlight_is_shaped(air)) {
      side.bend = litfog_airlight_shaped_bend(air, side, falloff, air.density);
      if (!litfog_has_cone(air.profile)) side.part = LITFOG_REAL(1.0);
    } else if (litfog_airlight_is_plain(air)) {
      side.bend = litfog_airlight_bend(air, side, end);
      if (!litfog_is_exp(air.mode)) side.part *= sqrt(side.part);
    }
  }
  return side;
}

// Side i of the lit part [low, high] of the ray: 0 and 1 about the closest approach, 2 and 3 about the crossing of a
// beam, which has the part on its side of the border. The sides about the closest approach leave out a hole around it,
// the plateau that has a closed form.
LitfogAirlightSide litfog_airlight_side_of(LitfogAirlight air, int i, LITFOG_REAL low, LITFOG_REAL high,
                                           LITFOG_REAL hole, LITFOG_REAL width, LITFOG_REAL crossing,
                                           LITFOG_REAL border, LITFOG_REAL beam_width, LITFOG_REAL falloff) {
  bool beyond = i == 1 || i == 3;
  bool by_crossing = i >= 2;
  bool takes_high = by_crossing == (crossing > LITFOG_REAL(0.0));
  LITFOG_REAL from = border != LITFOG_REAL(0.0) && takes_high ? max(low, border) : low;
  LITFOG_REAL to = border != LITFOG_REAL(0.0) && !takes_high ? min(high, border) : high;
  if (by_crossing) return litfog_airlight_side(air, from, to, crossing, beyond, beam_width, LITFOG_REAL(0.0));
  if (beyond && litfog_airlight_is_shaped(air))
    width = min(width, max(air.offset, litfog_airlight_shaped_scale(air.density, true)));
  return litfog_airlight_side(air, beyond ? max(from, hole) : from, beyond ? to : min(to, -hole), LITFOG_REAL(0.0),
                              beyond, width, falloff);
}

// The integral over a part of a side by some nodes, at least 1; more than 8 are spread over equal panels. A cookie has
// detail between nodes and takes panels of 2.
LITFOG_REAL litfog_airlight_between(LitfogAirlight air, LitfogAirlightSide side, LITFOG_REAL start, LITFOG_REAL end,
                                    int nodes) {
  int most_each = air.profile == LITFOG_REAL(LITFOG_PROFILE_COOKIE) ? 2 : 8;
  int panels = (nodes + most_each - 1) / most_each;
  int nodes_each = int(ceil(LITFOG_REAL(nodes) / LITFOG_REAL(panels)));
  int first = nodes_each * (nodes_each - 1) / 2;
  int node = first;
  LITFOG_REAL panel = LITFOG_REAL(0.0);
  LITFOG_REAL sum = LITFOG_REAL(0.0);
  int left = nodes_each * panels;
  LITFOG_REAL panel_size = LITFOG_REAL(1.0) / LITFOG_REAL(panels);
  // Where the part lies in the bent variable.
  LITFOG_REAL bent = LITFOG_REAL(1.0) + side.bend;
  LITFOG_REAL first_place = start * bent / (side.size + side.bend * start);
  LITFOG_REAL last_place = end < side.size ? end * bent / (side.size + side.bend * end) : LITFOG_REAL(1.0);
  LITFOG_REAL decay_length = side.rate == LITFOG_REAL(0.0) ? LITFOG_REAL(0.0) : LITFOG_REAL(1.0) / side.rate;
  do {
    LITFOG_REAL position = (panel + litfog_gauss_nodes[node]) * panel_size;
    LITFOG_REAL place = first_place + (last_place - first_place) * position;
    LITFOG_REAL nearer = LITFOG_REAL(1.0) / (LITFOG_REAL(1.0) + side.bend * (LITFOG_REAL(1.0) - place));
    LITFOG_REAL growth =
        exp(side.bend == LITFOG_REAL(0.0) ? start + (end - start) * position : side.size * place * nearer);
    LITFOG_REAL sinh_t = LITFOG_REAL(0.5) * (growth - LITFOG_REAL(1.0) / growth);
    LITFOG_REAL cosh_t = LITFOG_REAL(0.5) * (growth + LITFOG_REAL(1.0) / growth);
    LITFOG_REAL z = side.width * sinh_t;
    LITFOG_REAL decay = max(LITFOG_REAL(1.0) - side.rate * z, LITFOG_REAL(1.0e-7));  // e^(-q x) since the nearest end
    LITFOG_REAL x = side.nearest + (side.rate == LITFOG_REAL(0.0) ? z : -decay_length * log(decay));
    sum += litfog_gauss_weights[node] * nearer * nearer * (side.width * cosh_t / decay) *
           litfog_airlight_integrand(air, side.anchor + side.direction * x);
    ++node;
    if (node == first + nodes_each) {  // the next panel
      node = first;
      panel += LITFOG_REAL(1.0);
    }
    --left;
  } while (left > 0);
  if (side.bend == LITFOG_REAL(0.0)) return sum * (end - start) * panel_size;
  return sum * bent * side.size * (last_place - first_place) * panel_size;
}

// Where a cut lies on a side, if that is between x and next; else next.
LITFOG_REAL litfog_airlight_next(LitfogAirlightSide side, LITFOG_REAL cut, LITFOG_REAL x, LITFOG_REAL next) {
  LITFOG_REAL cut_x = (cut - side.anchor) * side.direction;
  return cut_x > x * LITFOG_REAL(1.00001) && cut_x < next ? cut_x : next;
}

// Where a side is cut into smooth pieces: distances along the ray from the closest approach, litfog_far for none.
struct LitfogAirlightCuts {
  bool are_made;
  bool are_exact;       // pieces share the nodes and none is added
  LITFOG_REAL least;    // how many nodes a piece has at least
  LITFOG_REAL plateau;  // and the same before the closest approach
  LitfogAirlightPart dark;
  LitfogAirlightPart inner;  // of a smoothstep cone's full brightness; of a wide one, where it is less
};

// The integral over a side by some nodes, spread over its pieces in proportion to their sizes.
LITFOG_REAL litfog_airlight_over(LitfogAirlight air, LitfogAirlightSide side, LitfogAirlightCuts cuts,
                                 LITFOG_REAL nodes) {
  LITFOG_REAL sum = LITFOG_REAL(0.0);
  LITFOG_REAL nodes_left = nodes;
  LITFOG_REAL x = side.nearest;
  LITFOG_REAL t = LITFOG_REAL(0.0);
  int pieces = 0;
  do {
    LITFOG_REAL next = side.farthest;
    LITFOG_REAL end = side.size;
    LITFOG_REAL part = nodes;
    bool is_dark = false;
    if (cuts.are_made) {
      next = litfog_airlight_next(side, cuts.plateau, x, next);
      next = litfog_airlight_next(side, -cuts.plateau, x, next);
      next = litfog_airlight_next(side, cuts.dark.low, x, next);
      next = litfog_airlight_next(side, cuts.dark.high, x, next);
      next = litfog_airlight_next(side, cuts.inner.low, x, next);
      next = litfog_airlight_next(side, cuts.inner.high, x, next);
      // z leaves too few nodes to what lies deep in the fog, where a phase function brightens it.
      if (!litfog_is_isotropic(air.phase) && side.rate > LITFOG_REAL(0.0)) {
        LITFOG_REAL deep = side.nearest + LITFOG_REAL(2.5) / side.rate;
        next = litfog_airlight_next(side, side.anchor + side.direction * deep, x, next);
      }
      LITFOG_REAL middle = side.anchor + side.direction * LITFOG_REAL(0.5) * (x + next);
      is_dark = middle > cuts.dark.low && middle < cuts.dark.high;
      end = litfog_airlight_t(side, next);
      part = max(floor(nodes * (end - t) / side.size + LITFOG_REAL(1.5)), cuts.least);
      if (cuts.are_exact) {
        part = nodes_left;
        if (next < side.farthest) {
          part = clamp(floor(nodes * (end - t) / side.size + LITFOG_REAL(0.5)), cuts.least, nodes_left - cuts.least);
        }
        nodes_left -= part;
      }
    }
    if (!is_dark) sum += litfog_airlight_between(air, side, t, end, int(part));
    x = next;
    t = end;
    ++pieces;
  } while (cuts.are_made && pieces < 8 && x < side.farthest);
  return sum;
}

// Where a ray that passes the lamp on the side to which it shines is nearest in angle to the cone's axis: distance
// along the ray from the closest approach. Needs axis_offset > 0. Farther away in either direction the angle grows.
LITFOG_REAL litfog_airlight_axis_crossing(LitfogAirlight air) {
  return air.axis_slope * air.offset * air.offset / air.axis_offset;
}

// The part of a ray that can contribute: inside extent, cone and the fog's reach.
struct LitfogAirlightStretch {
  LITFOG_REAL low;  // distances along the ray from the closest approach; equal where nothing can contribute
  LITFOG_REAL high;
  LitfogAirlightPart dark;  // within it, what a wide cone leaves dark; at litfog_far where that is nothing
};

// Cosine of the half angle beyond which a beam is dark, or so dim that it adds next to nothing to what it adds
// elsewhere on [low, high], though the phase function may brighten it there by so many optical depths.
LITFOG_REAL litfog_airlight_edge(LitfogAirlight air, LITFOG_REAL low, LITFOG_REAL high, LITFOG_REAL depths) {
  if (!litfog_cone_is_cut_off(air.profile)) return air.cone_x;
  LITFOG_REAL nearest = max(litfog_airlight_cosine(air, low, litfog_airlight_range(air, low)),
                            litfog_airlight_cosine(air, high, litfog_airlight_range(air, high)));
  if (air.axis_offset > LITFOG_REAL(0.0)) {
    LITFOG_REAL along = clamp(litfog_airlight_axis_crossing(air), low, high);
    nearest = max(nearest, litfog_airlight_cosine(air, along, litfog_airlight_range(air, along)));
  }
  LITFOG_REAL falloff = air.cone_y / (LITFOG_REAL(1.0) + depths / LITFOG_REAL(11.5));
  return litfog_cone_end(air.profile, nearest, air.cone_x, falloff);
}

// The part of a ray that the lamp lights: inside extent and cone.
LitfogAirlightStretch litfog_airlight_lit(LitfogAirlight air) {
  LitfogAirlightStretch lit;
  LITFOG_REAL chord = litfog_airlight_chord(air, air.extent);
  lit.low = max(-air.approach, -chord);
  lit.high = min(air.ray_length - air.approach, chord);
  lit.dark.low = litfog_far;
  lit.dark.high = litfog_far;
  if (!litfog_has_cone(air.profile) || !(lit.high > lit.low)) return lit;
  // Light is scattered the more backwards the farther along the ray.
  LITFOG_REAL forward = litfog_forward_depths(air.phase);
  LITFOG_REAL backward = litfog_backward_depths(air.phase);
  LitfogAirlightPart inside = litfog_airlight_inside(air, litfog_airlight_edge(air, lit.low, lit.high, forward));
  if (litfog_cone_is_cut_off(air.profile) && forward != backward) {
    inside.high = litfog_airlight_inside(air, litfog_airlight_edge(air, lit.low, lit.high, backward)).high;
  }
  if (!litfog_airlight_is_wide(air)) {
    lit.low = max(lit.low, inside.low);
    lit.high = inside.high > inside.low ? min(lit.high, inside.high) : lit.low;
  } else if (inside.high > inside.low && inside.high > lit.low && inside.low < lit.high) {
    if (inside.low <= lit.low) {
      lit.low = inside.high;
    } else if (inside.high >= lit.high) {
      lit.high = inside.low;
    } else {
      lit.dark = inside;
    }
  }
  return lit;
}

// Metres from the eye to where a ray enters the layers: 0 where the eye is in fog or between layers, litfog_far where
// the ray does not enter them.
LITFOG_REAL litfog_airlight_start_of_layers(LitfogAirlight air) {
  LITFOG_REAL height = litfog_airlight_height(air, -air.approach);
  if (litfog_airlight_density(air, -air.approach) > LITFOG_REAL(0.0)) return LITFOG_REAL(0.0);
  LITFOG_REAL bottom = litfog_knot_height(0);
  LITFOG_REAL top = litfog_knot_height(litfog_knot_count() - 1);
  if (height > bottom && height < top) return LITFOG_REAL(0.0);
  bool is_below = height <= bottom;
  bool enters = is_below ? air.rise > LITFOG_REAL(0.0) : air.rise < LITFOG_REAL(0.0);
  return enters ? ((is_below ? bottom : top) - height) / air.rise : litfog_far;
}

// Metres from the eye to where a ray has passed all layers and, where there is fog beyond, some optical depths of that.
LITFOG_REAL litfog_airlight_end_of_layers(LitfogAirlight air, LITFOG_REAL depths) {
  LITFOG_REAL eye_height = litfog_airlight_height(air, -air.approach);
  LITFOG_REAL end = LITFOG_REAL(0.0);
  LITFOG_REAL height = eye_height;
  if (air.rise != LITFOG_REAL(0.0)) {
    height = litfog_knot_height(air.rise > LITFOG_REAL(0.0) ? litfog_knot_count() - 1 : 0);
    end = max((height - eye_height) / air.rise, LITFOG_REAL(0.0));
  }
  LITFOG_REAL density = air.density + air.layer_scale * litfog_profile_density(height);
  return min(density > LITFOG_REAL(0.0) ? end + depths / density : end, litfog_far);
}

LitfogAirlightStretch litfog_airlight_stretch(LitfogAirlight air) {
  LitfogAirlightStretch stretch = litfog_airlight_lit(air);
  LITFOG_REAL low = stretch.low;
  LITFOG_REAL high = stretch.high;
  stretch.low = LITFOG_REAL(0.0);
  stretch.high = LITFOG_REAL(0.0);
  if (air.offset >= air.extent) return stretch;
  if (litfog_airlight_is_layered(air)) {
    LITFOG_REAL end = litfog_airlight_end_of_layers(air, LITFOG_REAL(100.0)) - air.approach;
    stretch.low = low;
    stretch.high = max(low, min(high, end));
    return stretch;
  }
  if (!(air.density > LITFOG_REAL(0.0))) return stretch;
  LITFOG_REAL fog_scale = LITFOG_REAL(1.0) / air.density;
  high = min(high, max(low, LITFOG_REAL(0.0)) + LITFOG_REAL(100.0) * fog_scale);
  if (!(high > low)) return stretch;

  // Cut where fog has dimmed it: exp fog to 1e-4 of its beginning, exp2 fog to 3e-4 of its brightest (of a point lamp
  // 1e-3), towards the eye to 1e-2 (2e-2). A lamp up to 6 fog scales away may be so much brighter than the fog before
  // it that the fog around the lamp counts, too.
  bool is_plain = litfog_airlight_is_plain(air);
  // Fog that scatters backwards is brighter far behind the lamp. So is fog that scatters forwards before the lamp,
  // which lies within the reach but in exp fog with a clear lamp leg.
  LITFOG_REAL depths = litfog_backward_depths(air.phase);
  if (litfog_is_exp(air.mode)) {
    // With a clear leg, the fog around a far lamp counts by how much brighter the lamp makes it than that at the eye.
    LITFOG_REAL nearest = litfog_airlight_range(air, clamp(LITFOG_REAL(0.0), low, high));
    LITFOG_REAL first = litfog_airlight_range(air, low);
    LITFOG_REAL brighter = log(litfog_attenuation(nearest, air.constant, air.linear, air.quadratic) /
                               litfog_attenuation(first, air.constant, air.linear, air.quadratic));
    high =
        min(high, air.lamp_leg == LITFOG_REAL(0.0)
                      ? low + (LITFOG_REAL(9.0) + brighter + max(litfog_forward_depths(air.phase), depths)) * fog_scale
                      : max(low, LITFOG_REAL(0.0)) + (LITFOG_REAL(4.5) + LITFOG_REAL(0.5) * depths) * fog_scale +
                            min(LITFOG_REAL(4.5) * fog_scale, air.offset));
  } else {
    LITFOG_REAL brightest = (LITFOG_REAL(0.5) * air.lamp_leg - LITFOG_REAL(1.0)) * air.approach;
    LITFOG_REAL legs = LITFOG_REAL(1.0) + air.lamp_leg;
    LITFOG_REAL reach = (is_plain ? LITFOG_REAL(6.6) : LITFOG_REAL(8.0) + depths) / legs * fog_scale * fog_scale;
    LITFOG_REAL distance = air.density * air.approach;  // in fog scales
    LITFOG_REAL behind_lamp =
        (is_plain ? LITFOG_REAL(0.9) : LITFOG_REAL(4.0)) * fog_scale / max(distance, LITFOG_REAL(2.0));
    bool has_lamp = distance > LITFOG_REAL(0.0) && distance < LITFOG_REAL(6.0);
    LITFOG_REAL before = max(low - brightest, LITFOG_REAL(0.0));
    LITFOG_REAL after = max(brightest - high, LITFOG_REAL(0.0));
    LITFOG_REAL last = brightest + sqrt(before * before + reach);
    high = min(high, has_lamp ? max(last, behind_lamp) : last);
    low = max(low, brightest - sqrt(after * after + LITFOG_REAL(0.6) * reach));
  }
  if (!(high > low)) return stretch;
  stretch.low = low;
  stretch.high = high;
  return stretch;
}

// An upper bound of the integral (airlight_bound.glsl). Along a ray the angle of scattering rises. A cone is at most
// what it is where the ray is nearest to its axis. s + k r falls nowhere along a ray, so that in exp fog it is least
// where the stretch begins; beyond the closest approach it rises as fast as s, so that no more than a fog scale counts
// of that side.
LITFOG_REAL litfog_airlight_bound(LitfogAirlight air, LitfogAirlightStretch stretch) {
  LITFOG_REAL size = stretch.high - stretch.low;
  LITFOG_REAL nearest = litfog_airlight_range(air, clamp(LITFOG_REAL(0.0), stretch.low, stretch.high));
  LITFOG_REAL lit = nearest;
  LITFOG_REAL thickest = air.density;
  if (litfog_airlight_is_layered(air)) {
    thickest += air.layer_scale * litfog_largest_profile_density();
  } else if (litfog_is_exp(air.mode)) {
    size = min(size, max(-stretch.low, LITFOG_REAL(0.0)) + LITFOG_REAL(1.0) / air.density);
    lit = litfog_airlight_range(air, stretch.low);
  }
  LITFOG_REAL seen = air.approach + stretch.low;
  LITFOG_REAL weight =
      litfog_largest_fog_weight(air.mode, thickest, air.density * seen, air.density * air.lamp_leg * lit);
  LITFOG_REAL denominator = litfog_denominator(nearest, air.constant, air.linear, air.quadratic);
  LITFOG_REAL beam = LITFOG_REAL(1.0);
  if (litfog_has_cone(air.profile) && air.axis_offset > LITFOG_REAL(0.0)) {
    LITFOG_REAL brightest = clamp(litfog_airlight_axis_crossing(air), stretch.low, stretch.high);
    beam = litfog_airlight_beam(air, brightest, litfog_airlight_range(air, brightest));
  }
  if (!litfog_is_isotropic(air.phase)) {
    LITFOG_REAL first = litfog_airlight_range(air, stretch.low);
    LITFOG_REAL least = first > LITFOG_REAL(0.0) ? litfog_airlight_versine(air, stretch.low, first) : LITFOG_REAL(0.0);
    beam *= litfog_largest_phase(air.phase, least, LITFOG_REAL(2.0));
  }
  return beam * litfog_largest_airlight(weight, denominator, air.quadratic, size);
}

// The first of the four sides from side i on that is not empty; 4 if there is none. Drivers without branches run a loop
// as often as the ray that needs it most, and most rays have one or two such sides.
int litfog_airlight_used_side(int i, LitfogAirlightSide before, LitfogAirlightSide beyond,
                              LitfogAirlightSide before_crossing, LitfogAirlightSide beyond_crossing) {
  if (i <= 0 && before.part > LITFOG_REAL(0.0)) return 0;
  if (i <= 1 && beyond.part > LITFOG_REAL(0.0)) return 1;
  if (i <= 2 && before_crossing.part > LITFOG_REAL(0.0)) return 2;
  return i <= 3 && beyond_crossing.part > LITFOG_REAL(0.0) ? 3 : 4;
}

// What a ray's integral is spread by.
struct LitfogAirlightShape {
  LITFOG_REAL density;   // at the closest approach, not 0
  LITFOG_REAL plateau;   // distance to the closest approach up to which the attenuation is clamped to 1
  LITFOG_REAL falloff;   // width of the attenuation
  LITFOG_REAL width;     // of all that changes about the closest approach
  bool crosses;          // whether a beam crosses the ray far from there
  LITFOG_REAL crossing;  // where
  LITFOG_REAL beam_width;
};

// The integral over a step of a ray in layers, on which it is smooth and the optical depth of both legs grows by
// `hidden` from low to high.
LITFOG_REAL litfog_airlight_step(LitfogAirlight air, LitfogAirlightShape shape, LITFOG_REAL low, LITFOG_REAL high,
                                 LITFOG_REAL hidden) {
  if (!(high > low)) return LITFOG_REAL(0.0);
  LITFOG_REAL middle = LITFOG_REAL(0.5) * (low + high);
  bool by_crossing = shape.crosses && abs(middle - shape.crossing) < abs(middle);
  LitfogAirlightSide side;
  side.anchor = by_crossing ? shape.crossing : LITFOG_REAL(0.0);
  side.direction = middle > side.anchor ? LITFOG_REAL(1.0) : LITFOG_REAL(-1.0);
  side.nearest = LITFOG_REAL(0.0);
  LITFOG_REAL nearest =
      max((side.direction > LITFOG_REAL(0.0) ? low : -high) - side.direction * side.anchor, LITFOG_REAL(0.0));
  side.farthest = (side.direction > LITFOG_REAL(0.0) ? high : -low) - side.direction * side.anchor;
  side.rate = LITFOG_REAL(0.0);
  side.width = by_crossing ? shape.beam_width : shape.width;
  if (!by_crossing && side.direction > LITFOG_REAL(0.0)) {
    side.width = min(side.width, max(air.offset, litfog_airlight_shaped_scale(shape.density, true)));
  }
  side.width = clamp(side.width, LITFOG_REAL(1.0e-6) * side.farthest, LITFOG_REAL(1000.0) * side.farthest);
  side.size = asinh(side.farthest / side.width);
  side.part = LITFOG_REAL(1.0);
  side.bend = LITFOG_REAL(0.0);
  if (!by_crossing && nearest <= LITFOG_REAL(0.0)) {
    // No nodes towards an approach that the fog hides from the other end.
    LITFOG_REAL hides = -side.direction * hidden;
    side.bend = litfog_airlight_shaped_bend(air, side, shape.falloff, shape.density) *
                clamp(LITFOG_REAL(1.0) - hides / LITFOG_REAL(3.0), LITFOG_REAL(0.0), LITFOG_REAL(1.0));
  }
  LITFOG_REAL start = asinh(nearest / side.width);
  // Short and nearly straight pieces need fewer nodes, unless the closest approach or a beam's edge bends them.
  LITFOG_REAL changes = LITFOG_REAL(2.0) * (side.size - start) + min(abs(hidden), LITFOG_REAL(9.0));
  LITFOG_REAL most = air.nodes > LITFOG_REAL(0.0) ? air.nodes : litfog_airlight_nodes(air);
  if (nearest <= LITFOG_REAL(0.0) || litfog_has_cone(air.profile)) changes += LITFOG_REAL(2.0);
  LITFOG_REAL nodes = min(ceil(LITFOG_REAL(0.1) * most * (LITFOG_REAL(1.0) + changes)), most);
  // No number of nodes comes from a NaN.
  return litfog_airlight_between(air, side, start, side.size, nodes >= LITFOG_REAL(2.0) ? int(nodes) : 2);
}

// How brightly the lamp lights a point of the ray and the fog there scatters that to the eye, but for optical depths.
// The edge of a beam counts as a tenth of its axis, for what lies beside it is soon brighter.
LITFOG_REAL litfog_airlight_shown(LitfogAirlight air, LITFOG_REAL along) {
  LITFOG_REAL range = litfog_airlight_range(air, along);
  LITFOG_REAL shown = litfog_attenuation(range, air.constant, air.linear, air.quadratic) *
                      max(litfog_airlight_beam(air, along, range), LITFOG_REAL(0.1));
  if (litfog_is_isotropic(air.phase) || range <= LITFOG_REAL(0.0)) return shown;
  return shown * litfog_phase(air.phase, litfog_airlight_versine(air, along, range));
}

// Of litfog_airlight_piece(), optical depths of both legs and fractions. With them the stated errors in layers hold
// (airlight_climb).
LITFOG_CONSTANT LITFOG_REAL litfog_step_depth = LITFOG_REAL(6.0);        // aimed at
LITFOG_CONSTANT LITFOG_REAL litfog_least_step_depth = LITFOG_REAL(2.5);  // of a step that is not the last
LITFOG_CONSTANT LITFOG_REAL litfog_largest_step_depth = LITFOG_REAL(9.0);
LITFOG_CONSTANT LITFOG_REAL litfog_seen_depth = LITFOG_REAL(8.0);       // e^-8 is a twelfth of an 8-bit step
LITFOG_CONSTANT LITFOG_REAL litfog_even_depth = LITFOG_REAL(1.5);       // steps up to it may be of any fog
LITFOG_CONSTANT LITFOG_REAL litfog_first_of_step = LITFOG_REAL(0.125);  // where others have less than
LITFOG_CONSTANT LITFOG_REAL litfog_depth_of_first = LITFOG_REAL(0.25);  // this of their depth

// The integral over a smooth piece of a ray in layers, of which the fog hides one end, `dim`, more than the other by an
// optical depth of both legs: in steps, until litfog_seen_depth is passed and as many depths more as the dim end is lit
// more brightly.
LITFOG_REAL litfog_airlight_piece(LitfogAirlight air, LitfogAirlightShape shape, LITFOG_REAL bright, LITFOG_REAL dim,
                                  LITFOG_REAL depth, LITFOG_REAL hidden) {
  LITFOG_REAL left = litfog_seen_depth;
  if (hidden > left) {
    left += log(max(litfog_airlight_shown(air, dim) / litfog_airlight_shown(air, bright), LITFOG_REAL(1.0)));
  }
  LITFOG_REAL sum = LITFOG_REAL(0.0);
  bool is_last = false;
  int steps = 0;
  do {
    // The depth is taken for a power of the distance, and where it is not that power is corrected.
    LITFOG_REAL whole = dim - bright;
    LITFOG_REAL size = whole;
    LITFOG_REAL passed = hidden;
    LITFOG_REAL aim = litfog_step_depth / hidden;
    LITFOG_REAL part = aim;
    for (int i = 0; i < 6 && (passed > litfog_largest_step_depth || (i > 0 && passed < litfog_least_step_depth)); ++i) {
      if (i > 0) part = pow(part, log(aim) / log(clamp(passed / hidden, LITFOG_REAL(1.0e-36), LITFOG_REAL(0.9))));
      size = part * whole;
      passed = litfog_airlight_depth(air, bright + size) - depth;
    }
    // Just inside a layer, the lamp's leg may grow far faster than the rest of the step.
    bool is_even = air.lamp_leg == LITFOG_REAL(0.0);
    for (int i = 0; i < 3 && !is_even && passed > litfog_even_depth; ++i) {
      LITFOG_REAL early = litfog_airlight_depth(air, bright + litfog_first_of_step * size) - depth;
      is_even = early < litfog_depth_of_first * passed;
      if (!is_even) {
        size *= litfog_first_of_step;
        passed = early;
      }
    }
    is_last = size == whole;
    LITFOG_REAL end = is_last ? dim : bright + size;
    sum += litfog_airlight_step(air, shape, min(bright, end), max(bright, end),
                                whole > LITFOG_REAL(0.0) ? passed : -passed);
    bright = end;
    depth += passed;
    hidden -= passed;
    left -= passed;
    ++steps;
  } while (steps < 12 && !is_last && left > LITFOG_REAL(0.0));
  return sum;
}

// The next end of a smooth piece after x, of those up to next.
LITFOG_REAL litfog_airlight_cut(LITFOG_REAL cut, LITFOG_REAL x, LITFOG_REAL next) {
  return cut > x && cut < next ? cut : next;
}

// The integral over the stretch of a ray in layers: over its pieces between knots, edges and the closest approach.
LITFOG_REAL litfog_airlight_in_layers(LitfogAirlight air, LitfogAirlightStretch stretch, LitfogAirlightShape shape) {
  LitfogAirlightPart inner;
  inner.low = litfog_far;
  inner.high = litfog_far;
  if (litfog_cone_has_inner_edge(air.profile)) inner = litfog_airlight_inside(air, air.cone_y);
  LITFOG_REAL sum = LITFOG_REAL(0.0);
  // Where the path from the lamp is steepest, that through the lamp's layer is shortest.
  LITFOG_REAL steepest = air.rise * air.offset * air.offset / (air.height - air.lamp_height);
  LITFOG_REAL x = stretch.low;
  LITFOG_REAL depth = litfog_airlight_depth(air, x);
  int pieces = 0;
  do {
    LITFOG_REAL next = litfog_airlight_cut(LITFOG_REAL(0.0), x, stretch.high);
    next = litfog_airlight_cut(shape.plateau, x, next);
    next = litfog_airlight_cut(-shape.plateau, x, next);
    next = litfog_airlight_cut(stretch.dark.low, x, next);
    next = litfog_airlight_cut(stretch.dark.high, x, next);
    next = litfog_airlight_cut(inner.low, x, next);
    next = litfog_airlight_cut(inner.high, x, next);
    if (shape.crosses) {
      next = litfog_airlight_cut(shape.crossing, x, next);
      next = litfog_airlight_cut(LITFOG_REAL(0.5) * shape.crossing, x, next);
    }
    for (int i = 0; i < litfog_knot_count(); ++i) {
      LITFOG_REAL above = litfog_knot_height(i) - air.height;
      if (abs(above) < litfog_far * abs(air.rise)) next = litfog_airlight_cut(above / air.rise, x, next);
    }
    LITFOG_REAL next_depth = litfog_airlight_depth(air, next);
    if (air.lamp_leg > LITFOG_REAL(0.0) && steepest > x && steepest < next) {
      LITFOG_REAL least = litfog_airlight_depth(air, steepest);
      if (least < min(depth, next_depth) - LITFOG_REAL(1.0)) {
        next = steepest;
        next_depth = least;
      }
    }
    LITFOG_REAL middle = LITFOG_REAL(0.5) * (x + next);
    bool is_dark = middle > stretch.dark.low && middle < stretch.dark.high;
    if (!is_dark && litfog_airlight_density(air, middle) > LITFOG_REAL(0.0)) {
      bool rises = next_depth > depth;
      sum += litfog_airlight_piece(air, shape, rises ? x : next, rises ? next : x, min(depth, next_depth),
                                   abs(next_depth - depth));
    }
    x = next;
    depth = next_depth;
    ++pieces;
  } while (pieces < 24 && x < stretch.high);
  return sum;
}

// The integral over the stretch of a ray.
LITFOG_REAL litfog_airlight_along(LitfogAirlight air, LitfogAirlightStretch stretch) {
  LITFOG_REAL low = stretch.low;
  LITFOG_REAL high = stretch.high;
  if (!(high > low)) return LITFOG_REAL(0.0);
  bool is_layered = litfog_airlight_is_layered(air);
  LITFOG_REAL density = air.density;
  if (is_layered) density = max(litfog_airlight_density(air, LITFOG_REAL(0.0)), LITFOG_REAL(1.0e-9));
  LITFOG_REAL fog_scale = LITFOG_REAL(1.0) / density;
  bool is_plain = litfog_airlight_is_plain(air);

#ifdef LITFOG_NO_KNEE
  LITFOG_REAL plateau = LITFOG_REAL(0.0);
#else
  LITFOG_REAL plateau = litfog_airlight_chord(air, litfog_airlight_level(air, LITFOG_REAL(1.0)));
#endif
  LITFOG_REAL sum = LITFOG_REAL(0.0);
  if (is_plain && min(high, plateau) > max(low, -plateau)) {
    sum = litfog_airlight_plateau(air, min(high, plateau)) - litfog_airlight_plateau(air, max(low, -plateau));
  }

  // The falloff's width: where the denominator has doubled. A phase function and the angle from a cone's axis change
  // over as little as the offset.
  LITFOG_REAL denominator = litfog_denominator(air.offset, air.constant, air.linear, air.quadratic);
  LITFOG_REAL doubled = litfog_airlight_level(air, LITFOG_REAL(2.0) * max(LITFOG_REAL(1.0), denominator));
  LITFOG_REAL falloff = min(litfog_airlight_chord(air, doubled), max(air.offset, LITFOG_REAL(2.0) * fog_scale));
  LITFOG_REAL width = falloff;
  if (!litfog_is_isotropic(air.phase) && !litfog_airlight_is_shaped(air))
    width = min(width, max(air.offset, LITFOG_REAL(2.0e-3) * fog_scale));
  if (air.profile == LITFOG_REAL(LITFOG_PROFILE_COOKIE)) width = min(width, max(air.offset, LITFOG_REAL(0.01) * width));

  // Where the ray is nearest to the beam's axis in angle, and the beam's width there.
  LITFOG_REAL crossing = LITFOG_REAL(0.0);
  LITFOG_REAL beam_width = litfog_far;
  bool crosses = false;
  if (litfog_has_cone(air.profile) && air.axis_offset > LITFOG_REAL(0.0)) {
    crossing = litfog_airlight_axis_crossing(air);
    LITFOG_REAL sine_squared = litfog_cone_sine_squared(air.profile, air.cone_x, air.cone_y);
    beam_width = LITFOG_REAL(1.2) * sqrt(sine_squared) * (air.offset * air.offset + crossing * crossing) /
                 max(air.offset, LITFOG_REAL(1.0e-9));
    crosses = !litfog_airlight_is_wide(air) && crossing > low && crossing < high && beam_width < width &&
              abs(crossing) > max(LITFOG_REAL(4.0) * beam_width, LITFOG_REAL(1.0e-5) * (high - low));
  }
  if (litfog_has_cone(air.profile) && !crosses) {
    beam_width = clamp(beam_width, LITFOG_REAL(0.25) * air.offset, LITFOG_REAL(2.0) * air.offset);
    // Where the closest approach is in clear air, the layers' fog may be far thicker.
    LITFOG_REAL scale = falloff;
    if (is_layered) {
      LITFOG_REAL thickest = air.density + air.layer_scale * litfog_largest_profile_density();
      scale = min(falloff, max(air.offset, LITFOG_REAL(2.0) / thickest));
    }
    // What passes the lamp within this distance adds next to nothing, unless the rest of the ray is at a dim angle.
    LITFOG_REAL rest = litfog_cone_at(air.profile, max(air.axis_slope, -air.axis_slope), air.cone_x, air.cone_y);
    width = min(width, max(beam_width, LITFOG_REAL(0.01) * rest * scale));
  }
  LITFOG_REAL largest = litfog_largest_phase(air.phase, LITFOG_REAL(0.0), LITFOG_REAL(2.0));
  if (is_layered) {
    LitfogAirlightShape shape;
    shape.density = density;
    shape.plateau = plateau;
    shape.falloff = falloff;
    shape.width = width;
    shape.crosses = crosses;
    shape.crossing = crossing;
    shape.beam_width = beam_width;
    return clamp(litfog_airlight_in_layers(air, stretch, shape), LITFOG_REAL(0.0), largest);
  }
  LITFOG_REAL border = crosses ? LITFOG_REAL(0.5) * crossing : LITFOG_REAL(0.0);

  // Nodes for each side in proportion to the root of its size in t, of a point lamp in exp2 fog to the power 3/4.
  LITFOG_REAL hole = is_plain ? plateau : LITFOG_REAL(0.0);
  LitfogAirlightSide before =
      litfog_airlight_side_of(air, 0, low, high, hole, width, crossing, border, beam_width, falloff);
  LitfogAirlightSide beyond =
      litfog_airlight_side_of(air, 1, low, high, hole, width, crossing, border, beam_width, falloff);
  LitfogAirlightSide before_crossing = before;
  LitfogAirlightSide beyond_crossing = beyond;
  before_crossing.part = LITFOG_REAL(0.0);
  beyond_crossing.part = LITFOG_REAL(0.0);
  if (before.bend < LITFOG_REAL(0.0)) beyond.part *= LITFOG_REAL(0.77);  // behind a far lamp
  LITFOG_REAL parts = before.part + beyond.part;
  if (crosses) {
    before_crossing = litfog_airlight_side_of(air, 2, low, high, hole, width, crossing, border, beam_width, falloff);
    beyond_crossing = litfog_airlight_side_of(air, 3, low, high, hole, width, crossing, border, beam_width, falloff);
    parts += before_crossing.part + beyond_crossing.part;
  }
  LITFOG_REAL nodes_left = air.nodes > LITFOG_REAL(0.0) ? air.nodes : litfog_airlight_nodes(air);
  LitfogAirlightCuts cuts;
  cuts.are_exact = !litfog_has_cone(air.profile) && litfog_airlight_is_shaped(air);
  cuts.are_made = !is_plain && nodes_left > LITFOG_REAL(8.0);
#ifdef LITFOG_NO_KNEE
  if (cuts.are_exact) cuts.are_made = false;  // nothing but the plateau is cut
#endif
  cuts.least = cuts.are_exact ? LITFOG_REAL(3.0) : max(LITFOG_REAL(5.0), floor(LITFOG_REAL(0.2) * nodes_left));
  cuts.plateau = plateau;
  cuts.dark = stretch.dark;
  cuts.inner.low = litfog_far;
  cuts.inner.high = litfog_far;
  if (cuts.are_made && litfog_cone_has_inner_edge(air.profile)) {
    cuts.inner = litfog_airlight_inside(air, air.cone_y);
  }
  int i = litfog_airlight_used_side(0, before, beyond, before_crossing, beyond_crossing);
  do {
    LitfogAirlightSide side = before;
    if (i == 1) side = beyond;
    if (i == 2) side = before_crossing;
    if (i == 3) side = beyond_crossing;
    if (side.part > LITFOG_REAL(0.0)) {
      LITFOG_REAL nodes = nodes_left * side.part / parts;
      bool is_last = side.part > LITFOG_REAL(0.99) * parts;
      parts = max(parts - side.part, LITFOG_REAL(1.0e-9));
      if (!cuts.are_made) {
        LITFOG_REAL most = is_last ? nodes_left : nodes_left - LITFOG_REAL(1.0);  // one for the other side
        nodes = max(min(floor(nodes + LITFOG_REAL(0.5)), most), LITFOG_REAL(1.0));
      }
      nodes_left -= nodes;
      sum += litfog_airlight_over(air, side, cuts, nodes);
    }
    i = litfog_airlight_used_side(i + 1, before, beyond, before_crossing, beyond_crossing);
  } while (i < 4);
  // No more than all that the fog takes from the ray is scattered into it.
  return clamp(sum, LITFOG_REAL(0.0), largest);
}

LITFOG_REAL litfog_airlight(LitfogAirlight air) { return litfog_airlight_along(air, litfog_airlight_stretch(air)); }

#undef LITFOG_TABLE
#undef LITFOG_TABLE_END
#undef LITFOG_CONSTANT
#undef LITFOG_REAL

#endif
