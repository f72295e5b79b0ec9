// SPDX-License-Identifier: Apache-2.0
#include "litfog/cone.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "float_limit.h"
#include "litfog/formulas.h"
#include "require.h"
#include "versine.h"

namespace litfog {

using std::numbers::pi;

std::optional<ValueError> check(const Cone& cone) {
  switch (cone.profile) {
    case ConeProfile::none:
      break;
    case ConeProfile::cosine:
      if (!(cone.half_angle > 0 && cutoff_angle(cone) <= pi / 2)) {
        return ValueError{"cone.half_angle", cone.half_angle, "must be in (0, pi/2]"};
      }
      if (!is_finite_and_not_negative(cone.exponent)) {
        return ValueError{"cone.exponent", cone.exponent, "must be finite and >= 0"};
      }
      break;
    case ConeProfile::smoothstep:
      if (!(cone.outer > 0 && cutoff_angle(cone) <= pi))
        return ValueError{"cone.outer", cone.outer, "must be in (0, pi]"};
      if (!(cone.inner >= 0 && cone.inner < cutoff_angle(cone))) {
        return ValueError{"cone.inner", cone.inner, "must be in [0, outer)"};
      }
      break;
  }
  return std::nullopt;
}

double cutoff_angle(const Cone& cone) {
  switch (cone.profile) {
    case ConeProfile::cosine:
      return snapped(cone.half_angle, 0, pi / 2);
    case ConeProfile::smoothstep:
      return snapped(cone.outer, 0, pi);
    case ConeProfile::none:
      break;
  }
  return pi;
}

double cone_at(const Cone& cone, double cos_angle) {
  switch (cone.profile) {
    case ConeProfile::cosine:
      return formulas::cosine_cone(cos_angle, std::cos(cutoff_angle(cone)), cone.exponent);
    case ConeProfile::smoothstep:
      return formulas::smoothstep_cone(cos_angle, std::cos(cone.inner), std::cos(cutoff_angle(cone)));
    case ConeProfile::none:
      break;
  }
  return 1;
}

double angle_at_level(const Cone& cone, double level) {
  switch (cone.profile) {
    case ConeProfile::cosine:
      if (cone.exponent == 0) return cutoff_angle(cone);
      return std::min(cutoff_angle(cone), angle_of_versine(-std::expm1(std::log(level) / cone.exponent)));
    case ConeProfile::smoothstep: {
      const double t = 0.5 - std::sin(std::asin(1 - 2 * level) / 3);  // root of t^2 (3 - 2 t) = level
      const double inner = versine(cone.inner);
      const double outer = versine(cutoff_angle(cone));
      return angle_of_versine(outer - t * (outer - inner));
    }
    case ConeProfile::none:
      break;
  }
  return pi;
}

double flux_within(const Cone& cone, double angle) {
  const double end = versine(std::min(angle, cutoff_angle(cone)));
  switch (cone.profile) {
    case ConeProfile::cosine:
      return 2 * pi * -std::expm1((cone.exponent + 1) * std::log1p(-end)) / (cone.exponent + 1);
    case ConeProfile::smoothstep: {
      const double inner = versine(cone.inner);
      const double outer = versine(cutoff_angle(cone));
      if (end <= inner) return 2 * pi * end;
      // The integral of t^2 (3 - 2 t) from t to 1 is (1 - t) (1 + t + t^2 - t^3) / 2.
      const double t = (outer - end) / (outer - inner);
      return 2 * pi * (inner + (end - inner) * (1 + t * (1 + t * (1 - t))) / 2);
    }
    case ConeProfile::none:
      break;
  }
  return 2 * pi * end;
}

}  // namespace litfog
