// SPDX-License-Identifier: Apache-2.0
#include "litfog/cone.h"

#include <cmath>
#include <numbers>

#include "litfog/formulas.h"
#include "require.h"

namespace litfog {

using std::numbers::pi;

std::optional<Refusal> check(const Cone& cone) {
  switch (cone.profile) {
    case ConeProfile::none:
      break;
    case ConeProfile::cosine:
      if (!(cone.half_angle > 0 && cone.half_angle <= pi / 2)) {
        return Refusal{"cone.half_angle", cone.half_angle, "must be in (0, pi/2]"};
      }
      if (!is_finite_and_not_negative(cone.exponent)) {
        return Refusal{"cone.exponent", cone.exponent, "must be finite and >= 0"};
      }
      break;
    case ConeProfile::smoothstep:
      if (!(cone.outer > 0 && cone.outer <= pi)) return Refusal{"cone.outer", cone.outer, "must be in (0, pi]"};
      if (!(cone.inner >= 0 && cone.inner < cone.outer)) {
        return Refusal{"cone.inner", cone.inner, "must be in [0, outer)"};
      }
      break;
  }
  return std::nullopt;
}

double cutoff_angle(const Cone& cone) {
  switch (cone.profile) {
    case ConeProfile::cosine:
      return cone.half_angle;
    case ConeProfile::smoothstep:
      return cone.outer;
    case ConeProfile::none:
      break;
  }
  return pi;
}

double cone_at(const Cone& cone, double cos_angle) {
  switch (cone.profile) {
    case ConeProfile::cosine:
      return formulas::litfog_cosine_cone(cos_angle, std::cos(cone.half_angle), cone.exponent);
    case ConeProfile::smoothstep:
      return formulas::litfog_smoothstep_cone(cos_angle, std::cos(cone.inner), std::cos(cone.outer));
    case ConeProfile::none:
      break;
  }
  return 1;
}

}  // namespace litfog
