// SPDX-License-Identifier: Apache-2.0
#include "litfog/light.h"

#include "require.h"

namespace litfog {

std::optional<ValueError> check(const Light& light) {
  constexpr const char* kRule = "must be finite and >= 0";
  if (!is_finite_and_not_negative(light.color.r)) return ValueError{"color.r", light.color.r, kRule};
  if (!is_finite_and_not_negative(light.color.g)) return ValueError{"color.g", light.color.g, kRule};
  if (!is_finite_and_not_negative(light.color.b)) return ValueError{"color.b", light.color.b, kRule};
  if (!is_finite_and_not_negative(light.density_scale)) return ValueError{"density_scale", light.density_scale, kRule};
  if (auto refusal = check(light.attenuation)) return refusal;
  if (auto refusal = check_threshold(light.threshold)) return refusal;
  return check(light.cone);
}

}  // namespace litfog
