// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "litfog/phase.h"

/// The phase function's formulas as C++: the text that the shaders share, for any scalar.
namespace litfog::phase_text {

using std::abs, std::max, std::sqrt;

/// As in litfog/shaders/phase.glsl.
template <typename Real>
struct PackedLobe {
  Real base, slope, scale, alpha;
};
template <typename Real>
struct PackedPhase {
  PackedLobe<Real> first, second;
};

#define LITFOG_REAL Real
#define LITFOG_FUNCTION template <typename Real>
#define LitfogPhaseLobe PackedLobe<Real>
#define LitfogPhase PackedPhase<Real>
#include "litfog/shaders/phase.glsl"  // undefines the first two
#undef LitfogPhaseLobe
#undef LitfogPhase

template <typename Real>
PackedPhase<Real> pack(const Phase& phase) {
  const auto lobe = [](const PhaseLobe& of, Real weight) {
    return litfog_packed_lobe(Real(of.asymmetry), Real(of.alpha), weight);
  };
  return {lobe(phase.first, Real(phase.weight)), lobe(phase.second, 1 - Real(phase.weight))};
}

}  // namespace litfog::phase_text
