// SPDX-License-Identifier: Apache-2.0
#include "litfog/cone.h"

#include <algorithm>
#include <cmath>

#include "float_limit.h"
#include "packed_cone.h"
#include "require.h"
#include "versine.h"

namespace litfog {

using std::numbers::pi;

namespace {

/// The root t of t^2 (3 - 2 t) = level, 1/2 - sin(asin(1 - 2 level) / 3), without its cancellation; level <= 1/2.
double smoothstep_root(double level) {
  const double third = std::asin(std::sqrt(level)) / 3;
  return 2 * std::cos(pi / 6 - third) * std::sin(third);
}

}  // namespace

std::optional<ValueError> find_error(const Cone& cone) {
  using namespace cone_parameters;
  const auto error = [&cone](const ConeParameter& of) { return ValueError{of.field, cone.*of.member, of.rule}; };
  const ConeParameter* const cutoff = facts_of(cone.profile).cutoff;
  if (cutoff && !(cone.*cutoff->member > 0 && cutoff_angle(cone) <= cutoff->most)) return error(*cutoff);
  switch (cone.profile) {
    case ConeProfile::none:
      break;
    case ConeProfile::cosine:
      if (!is_finite_and_not_negative(cone.exponent)) return error(kCosine[1]);
      break;
    case ConeProfile::smoothstep:
      if (!(cone.inner >= 0 && cone.inner < cutoff_angle(cone))) return error(kSmoothstep[0]);
      break;
  }
  return std::nullopt;
}

double cutoff_angle(const Cone& cone) {
  const ConeParameter* const cutoff = facts_of(cone.profile).cutoff;
  return cutoff ? snapped(cone.*cutoff->member, 0, cutoff->most) : pi;
}

double cutoff_level(const Cone& cone) {
  const auto [profile, x, y] = packed_cone<double>(cone);
  return formulas::litfog_cone_is_cut_off(profile) ? formulas::litfog_cone_at(profile, x, 0.0, y) : 0;
}

double dim_angle(const Cone& cone) {
  switch (cone.profile) {
    case ConeProfile::cosine:
      return std::min(std::acos(std::exp2(-1 / std::max(cone.exponent, 1e-3))), cutoff_angle(cone));
    case ConeProfile::smoothstep:
    case ConeProfile::none:
      break;
  }
  return cutoff_angle(cone);
}

double cone_at(const Cone& cone, double cos_angle) {
  const auto [profile, x, y] = packed_cone<double>(cone);
  return formulas::litfog_cone_at(profile, cos_angle, x, y);
}

double angle_at_level(const Cone& cone, double level) {
  switch (cone.profile) {
    case ConeProfile::cosine:
      if (cone.exponent == 0) return cutoff_angle(cone);
      return std::min(cutoff_angle(cone), angle_of_versine(-std::expm1(std::log(level) / cone.exponent)));
    case ConeProfile::smoothstep: {
      // cos u is a part t of the inner cosine and the rest of the outer. No digit of the smaller part cancels.
      const double least = smoothstep_root(std::min(level, 1 - level)), most = 1 - least;
      const double t = level < 0.5 ? least : most, rest = level < 0.5 ? most : least;
      const auto mean = [&](double inner, double outer) { return std::sqrt(t * inner * inner + rest * outer * outer); };
      const double inner = cone.inner / 2, outer = cutoff_angle(cone) / 2;
      return 2 * std::atan2(mean(std::sin(inner), std::sin(outer)), mean(std::cos(inner), std::cos(outer)));
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
