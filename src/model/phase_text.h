// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "litfog/phase.h"

namespace litfog {

template <typename Real>
BasicPhase<Real> convert(const Phase& phase) {
  return {Real(phase.asymmetry)};
}

/// The phase function's formulas as C++: the text that the shaders share, for any scalar.
namespace phase_text {

using std::abs, std::max, std::sqrt;

#define LITFOG_REAL Real
#define LITFOG_FUNCTION template <typename Real>
#define LitfogPhase BasicPhase<Real>
#include "litfog/shaders/phase.glsl"  // undefines the first two
#undef LitfogPhase

}  // namespace phase_text
}  // namespace litfog
