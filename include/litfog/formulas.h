// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

/// The model's scalar formulas for float, double and any type with the usual functions by argument-dependent lookup
/// (ceres::Jet). The text is shared with the shaders: litfog/shaders/formulas.glsl.
namespace litfog::formulas {

template <typename Real>
Real litfog_expm1(const Real& x) {
  using std::expm1;
  return expm1(x);
}

using std::pow;

#define LITFOG_REAL Real
#define LITFOG_FUNCTION template <typename Real>
#include "litfog/shaders/formulas.glsl"  // undefines both

}  // namespace litfog::formulas
