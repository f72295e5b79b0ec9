// SPDX-License-Identifier: Apache-2.0
#include "litfog/attenuation.h"

#include "level_range.h"
#include "litfog/formulas.h"
#include "require.h"
#include "unchecked.h"

namespace litfog {
namespace {

double level_range_in_double(const Attenuation& attenuation, double level) {
  if (is_in_safe_range(attenuation.constant, attenuation.linear, attenuation.quadratic, level)) {
    return level_range(attenuation, level).high;
  }
  return double(level_range<long double>(convert<long double>(attenuation), level).high);
}

}  // namespace

std::optional<ValueError> find_error(const Attenuation& attenuation) {
  const auto [constant, linear, quadratic] = attenuation;
  constexpr const char* kRule = "must be finite and >= 0";
  if (!is_finite_and_not_negative(constant)) return ValueError{"attenuation.constant", constant, kRule};
  if (!is_finite_and_not_negative(linear)) return ValueError{"attenuation.linear", linear, kRule};
  if (!is_finite_and_not_negative(quadratic)) return ValueError{"attenuation.quadratic", quadratic, kRule};
  if (constant == 0 && linear == 0 && quadratic == 0) {
    return ValueError{"attenuation.constant", constant, "must be > 0 where linear and quadratic are 0"};
  }
  return std::nullopt;
}

std::optional<ValueError> find_threshold_error(double threshold) {
  if (!(threshold > 0 && threshold < 1)) return ValueError{"threshold", threshold, "must be in (0, 1)"};
  return std::nullopt;
}

double attenuation_at(const Attenuation& attenuation, double range) {
  const auto [constant, linear, quadratic] = attenuation;
  if (std::isinf(range)) {  // 0 * infinity is no value
    return linear == 0 && quadratic == 0 ? attenuation_at(attenuation, 0) : 0;
  }
  return formulas::attenuation(range, constant, linear, quadratic);
}

double unchecked::compute_extent(const Attenuation& attenuation, double threshold) {
  return level_range_in_double(attenuation, threshold);
}

double compute_extent(const Attenuation& attenuation, double threshold) {
  require(find_error(attenuation));
  require(find_threshold_error(threshold));
  return unchecked::compute_extent(attenuation, threshold);
}

float compute_extent(const AttenuationF& attenuation, float threshold) {
  return float(
      compute_extent(Attenuation{attenuation.constant, attenuation.linear, attenuation.quadratic}, double(threshold)));
}

double compute_knee(const Attenuation& attenuation) {
  require(find_error(attenuation));
  return level_range_in_double(attenuation, 1);
}

}  // namespace litfog
