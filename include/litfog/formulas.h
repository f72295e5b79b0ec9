// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

/// The model's scalar formulas for float, double and any type whose math functions argument-dependent lookup finds
/// (ceres::Jet). The text is shared with the shaders: formulas.glsl, cone_profile.glsl and airlight_bound.glsl of
/// litfog/shaders. The names in the macros below lose the shaders' prefix litfog_; others keep it.
namespace litfog::formulas {

using std::exp;
using std::expm1;
using std::max;
using std::min;
using std::pow;
using std::sqrt;

#define litfog_expm1 expm1
#define litfog_denominator denominator
#define litfog_attenuation attenuation
#define litfog_depth_exp depth_exp
#define litfog_depth_exp2 depth_exp2
#define litfog_is_exp is_exp
#define litfog_opacity opacity
#define litfog_cosine_cone cosine_cone
#define litfog_smoothstep_cone smoothstep_cone
#define LITFOG_REAL Real
#define LITFOG_FUNCTION template <typename Real>
#include "litfog/shaders/formulas.glsl"  // undefines the last two
#define LITFOG_REAL Real
#define LITFOG_FUNCTION template <typename Real>
#include "litfog/shaders/cone_profile.glsl"  // undefines them, too
#define LITFOG_REAL Real
#define LITFOG_FUNCTION template <typename Real>
#include "litfog/shaders/airlight_bound.glsl"  // undefines them, too
#undef litfog_expm1
#undef litfog_denominator
#undef litfog_attenuation
#undef litfog_depth_exp
#undef litfog_depth_exp2
#undef litfog_is_exp
#undef litfog_opacity
#undef litfog_cosine_cone
#undef litfog_smoothstep_cone

}  // namespace litfog::formulas
