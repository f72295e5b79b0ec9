// SPDX-License-Identifier: Apache-2.0
#include "litfog/light.h"

#include "require.h"

namespace litfog {

std::optional<Refusal> check(const Light& light) {
  constexpr const char* kRule = "must be finite and >= 0";
  if (!is_finite_and_not_negative(light.color.r)) return Refusal{"color.r", light.color.r, kRule};
  if (!is_finite_and_not_negative(light.color.g)) return Refusal{"color.g", light.color.g, kRule};
  if (!is_finite_and_not_negative(light.color.b)) return Refusal{"color.b", light.color.b, kRule};
  if (!is_finite_and_not_negative(light.density_scale)) return Refusal{"density_scale", light.density_scale, kRule};
  if (auto refusal = check(light.attenuation)) return refusal;
  if (auto refusal = check_threshold(light.threshold)) return refusal;
  return check(light.cone);
}

}  // namespace litfog
