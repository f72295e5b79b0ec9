// SPDX-License-Identifier: Apache-2.0
#include "litfog/light.h"

#include "require.h"

namespace litfog {

std::optional<ValueError> find_error(const Light& light) {
  if (const auto error = check_color(light.color, {"color.r", "color.g", "color.b"})) return error;
  if (!is_finite_and_not_negative(light.density_scale)) {
    return ValueError{"density_scale", light.density_scale, "must be finite and >= 0"};
  }
  if (const auto error = find_error(light.attenuation)) return error;
  if (const auto error = find_threshold_error(light.threshold)) return error;
  return find_error(light.cone);
}

std::optional<ValueError> find_error(const PlacedLight& placed) {
  if (const auto error = find_position_error(placed.position, {"position.x", "position.y", "position.z"})) return error;
  if (const auto error = find_direction_error(placed.direction, "direction")) return error;
  return find_error(placed.light);
}

}  // namespace litfog
