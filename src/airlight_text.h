// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "litfog/formulas.h"

// The text of the airlight in double, shared with the shaders: litfog/shaders/airlight.glsl.

namespace litfog::airlight_text {

using std::abs, std::asinh, std::clamp, std::exp, std::floor, std::log, std::max, std::min, std::sqrt;

/// Cookie  called with a distance along the ray from its closest approach to the light: the fraction of the light's
///         axial intensity there, for profile 3
template <typename Cookie>
struct Text {
  const Cookie& cookie;

  struct LitfogAirlight;
  double litfog_airlight_cookie(const LitfogAirlight&, double along) const { return cookie(along); }

#define LITFOG_COOKIES
#define LITFOG_REAL double
#define LITFOG_CONSTANT static constexpr
#define litfog_expm1 std::expm1
#define litfog_denominator formulas::denominator
#define litfog_attenuation formulas::attenuation
#define litfog_cosine_cone formulas::cosine_cone
#define litfog_smoothstep_cone formulas::smoothstep_cone
#include "litfog/shaders/airlight.glsl"  // undefines LITFOG_REAL and LITFOG_CONSTANT
#undef litfog_expm1
#undef litfog_denominator
#undef litfog_attenuation
#undef litfog_cosine_cone
#undef litfog_smoothstep_cone
#undef LITFOG_COOKIES
};

}  // namespace litfog::airlight_text
