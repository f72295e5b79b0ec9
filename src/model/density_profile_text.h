// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "litfog/density_profile.h"

namespace litfog {

template <typename Real>
BasicDensityProfile<Real> convert(const DensityProfile& profile) {
  BasicDensityProfile<Real> result{.count = profile.count};
  for (std::size_t i = 0; i < profile.count; ++i) {
    result.knots[i] = {Real(profile.knots[i].height), Real(profile.knots[i].density)};
  }
  return result;
}

/// The density profile's formulas as C++: the text that the shaders share, for any scalar.
template <typename Real>
struct DensityProfileText {
  const BasicDensityProfile<Real>& profile;

  int litfog_knot_count() const { return int(profile.count); }
  Real litfog_knot_height(int knot) const { return profile.knots[std::size_t(knot)].height; }
  Real litfog_knot_density(int knot) const { return profile.knots[std::size_t(knot)].density; }

  static Real abs(Real x) { return std::abs(x); }
  static Real max(Real a, Real b) { return std::max(a, b); }
  static Real min(Real a, Real b) { return std::min(a, b); }

#define LITFOG_REAL Real
#define LITFOG_FUNCTION
#include "litfog/shaders/density_profile.glsl"  // undefines both
};

}  // namespace litfog
