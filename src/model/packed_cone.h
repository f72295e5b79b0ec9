// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "litfog/cone.h"
#include "litfog/formulas.h"

namespace litfog {

/// A cone as litfog/shaders/cone_profile.glsl takes it. A profile's number is its enumerator's.
template <typename Real>
struct PackedCone {
  Real profile;
  Real x;
  Real y;
};

template <typename Real>
PackedCone<Real> packed_cone(const Cone& cone) {
  const Real profile = Real(int(cone.profile));
  switch (cone.profile) {
    case ConeProfile::cosine:
      return {profile, std::cos(Real(cutoff_angle(cone))), Real(cone.exponent)};
    case ConeProfile::smoothstep:
      return {profile, std::cos(Real(cutoff_angle(cone))), std::cos(Real(cone.inner))};
    case ConeProfile::none:
      break;
  }
  return {profile, 0, 0};
}

constexpr bool is_profile(int number) {
  switch (ConeProfile(number)) {
    case ConeProfile::none:
      return number == LITFOG_PROFILE_NONE;
    case ConeProfile::cosine:
      return number == LITFOG_PROFILE_COSINE;
    case ConeProfile::smoothstep:
      return number == LITFOG_PROFILE_SMOOTHSTEP;
  }
  return false;
}
static_assert(is_profile(int(kConeProfiles.size()) - 1) && !is_profile(int(kConeProfiles.size())),
              "kConeProfiles has them all");
static_assert(LITFOG_PROFILE_COOKIE >= kConeProfiles.size(), "no profile has a cookie's number");

}  // namespace litfog
