// SPDX-License-Identifier: Apache-2.0
#include "litfog/light_bounds.h"

#include "require.h"

namespace litfog {

std::optional<ValueError> check(const LightBounds& bounds) {
  if (const auto error = check_position(bounds.position, {"position.x", "position.y", "position.z"})) return error;
  if (const auto error = check_direction(bounds.direction, "direction")) return error;
  if (!(bounds.range >= 0)) return ValueError{"range", bounds.range, "must be >= 0"};
  if (!(bounds.half_angle >= 0 && bounds.half_angle <= std::numbers::pi)) {
    return ValueError{"half_angle", bounds.half_angle, "must be in [0, pi]"};
  }
  return std::nullopt;
}

}  // namespace litfog
