// SPDX-License-Identifier: Apache-2.0
#include "litfog/light.h"

#include "require.h"

namespace litfog {

std::optional<ValueError> check(const Light& light) {
  if (const auto error = check_color(light.color, {"color.r", "color.g", "color.b"})) return error;
  if (!is_finite_and_not_negative(light.density_scale)) {
    return ValueError{"density_scale", light.density_scale, "must be finite and >= 0"};
  }
  if (const auto error = check(light.attenuation)) return error;
  if (const auto error = check_threshold(light.threshold)) return error;
  return check(light.cone);
}

std::optional<ValueError> check(const PlacedLight& placed) {
  if (const auto error = check_position(placed.position, {"position.x", "position.y", "position.z"})) return error;
  if (const auto error = check_direction(placed.direction, "direction")) return error;
  return check(placed.light);
}

}  // namespace litfog
